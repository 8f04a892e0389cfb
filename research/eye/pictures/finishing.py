"""Post-processing of a picture: cartoon ink, lens, sensor, colours, JPEG."""

from __future__ import annotations

import cv2
import numpy as np
from jaxtyping import Float, Int, UInt8


def cartoon(
    rng: np.random.Generator,
    image: Float[np.ndarray, "h w 3"],
    ids: Int[np.ndarray, "h w"],
    depth: Float[np.ndarray, "h w"],
) -> Float[np.ndarray, "h w 3"]:
    """Return the picture with flat, saturated colours and dark lines at object and depth edges."""
    flat = np.clip(image, 0, 255).astype(np.uint8)
    for _ in range(2):
        flat = cv2.bilateralFilter(flat, 7, 40, 5)
    hsv = cv2.cvtColor(flat, cv2.COLOR_RGB2HSV).astype(np.float32)
    hsv[..., 1] = np.clip(hsv[..., 1] * rng.uniform(1.1, 1.7), 0, 255)
    if rng.random() < 0.6:
        steps = int(rng.integers(4, 10))
        value = np.round(hsv[..., 2] / 255 * steps) / steps * 255
        hsv[..., 2] = np.where(hsv[..., 2] > 250, 255, value)
    flat = cv2.cvtColor(hsv.astype(np.uint8), cv2.COLOR_HSV2RGB).astype(np.float32)
    near = 1 / np.minimum(depth, 50).astype(np.float32)
    bend = np.abs(cv2.Laplacian(near, cv2.CV_32F)) / near
    edge = (bend > rng.uniform(0.02, 0.06)).astype(np.uint8)
    edge[:, 1:] |= (ids[:, 1:] != ids[:, :-1]).astype(np.uint8)
    edge[1:] |= (ids[1:] != ids[:-1]).astype(np.uint8)
    width = int(rng.integers(1, 5))
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (width, width))
    line = cv2.GaussianBlur(cv2.dilate(edge, kernel).astype(np.float32), (0, 0), 0.6)
    line = np.clip(line * 1.3, 0, 1)[..., None]
    return flat * (1 - line) + rng.uniform(0, 60) * line


def develop(
    rng: np.random.Generator, image: Float[np.ndarray, "h w 3"], clean: bool
) -> UInt8[np.ndarray, "h w 3"]:
    """Return the picture as taken by a camera; ``clean`` keeps white pure."""
    image = np.clip(image, 0, 255) / 255
    if rng.random() < 0.6:
        image = image ** float(np.exp(rng.normal(0, 0.16 if clean else 0.3)))
    if not clean:
        if rng.random() < 0.6:
            image = image * np.exp(rng.normal(0, 0.07, 3))
        if rng.random() < 0.5:
            image = image * float(np.exp(rng.normal(-0.08, 0.2)))
        if rng.random() < 0.3:
            image = (image - 0.5) * float(rng.uniform(0.65, 1.2)) + 0.5
        if rng.random() < 0.25:
            image = image * _vignette(rng, image.shape)
    if rng.random() < 0.35:
        grey = image.mean(2, keepdims=True)
        image = grey + (image - grey) * float(rng.uniform(0.4, 1.5))
    image = np.clip(image, 0, 1).astype(np.float32)
    image = _lens(rng, image, clean)
    if rng.random() < (0.25 if clean else 0.7):
        sigma = float(rng.exponential(0.006 if clean else 0.018))
        noise = rng.normal(0, sigma, image.shape).astype(np.float32)
        if rng.random() < 0.5:  # blur of a sensor's filter
            noise = cv2.GaussianBlur(noise, (0, 0), 0.8) * 1.6
        image = image + noise
    out = np.round(np.clip(image, 0, 1) * 255).astype(np.uint8)
    if rng.random() < 0.4:
        quality = [cv2.IMWRITE_JPEG_QUALITY, int(rng.integers(35, 95))]
        out = cv2.imdecode(cv2.imencode(".jpg", out, quality)[1], cv2.IMREAD_COLOR)
    return np.ascontiguousarray(out)


def _vignette(rng: np.random.Generator, shape: tuple[int, ...]) -> Float[np.ndarray, "h w 1"]:
    y, x = np.mgrid[-1 : 1 : shape[0] * 1j, -1 : 1 : shape[1] * 1j]
    return 1 - rng.uniform(0.1, 0.5) * ((x * x + y * y) / 2)[..., None]


def _lens(
    rng: np.random.Generator, image: Float[np.ndarray, "h w 3"], clean: bool
) -> Float[np.ndarray, "h w 3"]:
    """Blur, as by focus, motion or scaling, or sharpen."""
    chance = rng.random()
    if chance < 0.25:
        return cv2.GaussianBlur(image, (0, 0), float(rng.uniform(0.3, 1.0 if clean else 1.8)))
    if chance < 0.35:
        soft = cv2.GaussianBlur(image, (0, 0), 1.0)
        return np.clip(image + (image - soft) * float(rng.uniform(0.3, 1.2)), 0, 1)
    if chance < 0.43:
        small = float(rng.uniform(0.4, 0.8))
        less = cv2.resize(image, None, fx=small, fy=small, interpolation=cv2.INTER_AREA)
        return cv2.resize(less, image.shape[1::-1], interpolation=cv2.INTER_CUBIC).clip(0, 1)
    if chance < 0.47 and not clean:
        length = int(rng.integers(3, 8))
        kernel = np.zeros((length, length), np.float32)
        kernel[length // 2] = 1 / length
        turn = cv2.getRotationMatrix2D((length / 2, length / 2), float(rng.uniform(0, 180)), 1)
        line = np.asarray(cv2.warpAffine(kernel, turn, (length, length)), np.float32)
        return cv2.filter2D(image, -1, line / np.float32(max(float(line.sum()), 1e-3)))
    return image
