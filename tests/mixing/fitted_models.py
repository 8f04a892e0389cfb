"""Tiny models of transformers' classes that detect the objects of a few pictures.

All of their weights are random but for the last layers, which are solved for (least squares) so
that the right boxes, words and masks of these pictures come out; they know nothing else. What is
real is the classes, their files, and everything that the backend does with their answers.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import tiny_models
import torch
import transformers
from torch import Tensor
from torch.nn import functional

from generator.backends.huggingface.detection.detections import IMAGENET, bound_size, to_batch
from generator.backends.huggingface.detection.phrases import questions
from generator.backends.huggingface.weights.pins import pins, snapshot
from generator.geometry import mask_box

SIDE = 96
"""Shorter side at which the detector looks at a picture, pixels."""

MASKS = 256
"""Side at which the masker looks at a picture, pixels."""

_SURE = 4.0  # logit of what is there; its negative is that of what is not
_LARGE = 8.0
_STEPS = 100
_DAMPED = 1e-6  # of the largest feature: keeps what was solved for from hanging on rounding


@dataclass(frozen=True, eq=False)
class Example:
    """A picture, its words in request order, and the mask of each."""

    image: np.ndarray
    words: Sequence[str]
    masks: Mapping[str, np.ndarray]

    @property
    def boxes(self) -> Tensor:
        """The words' boxes as shares of the picture's sides."""
        high, wide = self.image.shape[:2]
        boxes = np.stack([mask_box(self.masks[word]) for word in self.words])
        return torch.tensor(boxes / [wide, high, wide, high])


def save(folder: Path, examples: Sequence[Example]) -> Path:
    """Save a detector, a masker and an encoder fitted to the examples at their pins' paths."""
    torch.manual_seed(0)
    made = {
        "grounding-dino-tiny": detector(examples),
        "sam2": masker(examples),
        "dinov2": tiny_models.dinov2(),
    }
    for name, model in made.items():
        home = snapshot(pins()[name], folder)
        model.save_pretrained(home)
        if "tokenizer.json" in pins()[name].files:
            tiny_models.letters_tokenizer().save(str(home / "tokenizer.json"))
    return folder


def detector(examples: Sequence[Example]) -> Any:
    """Return a Grounding DINO whose first queries have the words and boxes of the examples."""
    network = tiny_models.grounding_dino(
        d_model=64, decoder_layers=1, decoder_ffn_dim=64, decoder_bbox_embed_share=False
    ).eval()
    _teach_words(network, examples)
    _teach_boxes(network, examples)
    return network


@torch.no_grad()
def _teach_words(network: Any, examples: Sequence[Example]) -> None:
    """Solve for the last layer of the decoder: what its queries are, times a token, is a logit."""
    layer, norm = network.model.decoder.layers[0], network.model.decoder.layer_norm
    before, wanted, sizes = [], [], []
    for example in examples:
        question, given = _asked(network, example)
        (residual,) = _inputs(network, layer.fc1, given)
        (inner,) = _inputs(network, layer.fc2, given)
        right = torch.full((residual.shape[1], len(question.ids)), -1.0)
        for k, tokens in enumerate(question.tokens):
            right[k, list(tokens)] = 1.0
        text = network(**given).encoder_last_hidden_state_text[0]
        rows = torch.cat([text, torch.ones(1, text.shape[1])])  # layer norm leaves no mean
        hidden = _solved(rows, functional.pad(right, (0, 1)).T).T
        size = hidden.std(1, correction=0, keepdim=True)  # nor any size but 1
        before.append(inner[0])
        wanted.append(hidden / size - residual[0])
        sizes.append(size[: len(question.words)].max())
    _solve(layer.fc2, torch.cat(before), torch.cat(wanted))
    norm.weight *= _SURE * max(sizes)


@torch.no_grad()
def _teach_boxes(network: Any, examples: Sequence[Example]) -> None:
    """Solve for the last layer of the head that moves the first queries' boxes."""
    head = network.bbox_embed[0].layers[-1]
    before, wanted = [], []
    for example in examples:
        _, given = _asked(network, example)
        (features,) = _inputs(network, head, given)
        boxes = example.boxes
        shares = torch.cat([(boxes[:, :2] + boxes[:, 2:]) / 2, boxes[:, 2:] - boxes[:, :2]], 1)
        first = network(**given).init_reference_points[0, : len(boxes)]
        before.append(features[0, : len(boxes)])
        wanted.append(torch.special.logit(shares, 1e-4) - torch.special.logit(first, 1e-5))
    _solve(head, torch.cat(before), torch.cat(wanted))


def masker(examples: Sequence[Example]) -> Any:
    """Return a SAM 2 that masks the content of the examples' boxes.

    Its finest maps, made of local colours alone, and what each mask adds up of them are fitted;
    then the layer that makes the latter of the box is solved for.
    """
    network = tiny_models.sam2(
        MASKS, hidden_size=128, width=32, dynamic_multimask_via_stability=False
    )
    network.eval().requires_grad_(False)
    decoder = network.mask_decoder
    head = decoder.output_hypernetworks_mlps[0].proj_out
    for weight in network.vision_encoder.backbone.parameters():
        if weight.ndim > 1:
            weight.mul_(_LARGE)  # makes its output nonlinear in the colours
    decoder.upscale_conv2.weight.zero_()
    boxes, maps, right = [], [], []
    for example in examples:
        given = {
            "pixel_values": to_batch(example.image, MASKS, MASKS, IMAGENET),
            "input_boxes": (MASKS * example.boxes[None]).float(),
            "multimask_output": False,
        }
        (features,) = _inputs(network, head, given)
        (map_,) = _inputs(network, decoder.conv_s0, given)
        masks = torch.stack([torch.tensor(example.masks[w]).float() for w in example.words])
        boxes.append(features[0])
        maps.append(map_)
        right.append(functional.interpolate(masks[:, None], map_.shape[-2:], mode="area")[:, 0])
    sums = _fitted_sums(decoder.conv_s0, decoder.activation, maps, right)
    _solve(head, torch.cat(boxes), sums)
    return network.requires_grad_(False)


def _fitted_sums(
    layer: torch.nn.Conv2d,
    activation: torch.nn.Module,
    maps: Sequence[Tensor],
    right: Sequence[Tensor],
) -> Tensor:
    """Fit a layer so that weighted sums of its maps are the true masks; return the weights."""
    spread = 1 / (layer.in_channels**0.5 * float(torch.cat([m.flatten() for m in maps]).std()))
    layer.weight.data.normal_(0, spread)
    layer.bias.data.normal_(0, 1)
    sums = torch.nn.Parameter(0.3 * torch.randn(sum(map(len, right)), layer.out_channels))
    ours = [*layer.requires_grad_().parameters()]
    descent = torch.optim.Adam(
        [{"params": [sums], "lr": 0.1}, {"params": ours, "lr": 0.04 * spread}]
    )
    for _ in range(_STEPS):
        descent.zero_grad()
        total = torch.zeros(())
        for map_, masks, own in zip(maps, right, sums.split([*map(len, right)]), strict=True):
            found = torch.einsum("nc,chw->nhw", own, activation(layer(map_))[0])
            total = total + functional.binary_cross_entropy_with_logits(found, masks)
        total.backward()
        descent.step()
    return sums.detach()


def _asked(network: Any, example: Example) -> tuple[Any, dict[str, Tensor]]:
    """Return the words as a prompt, and the inputs of Grounding DINO."""
    tokenizer = transformers.PreTrainedTokenizerFast(
        tokenizer_object=tiny_models.letters_tokenizer()
    )
    words = tuple(example.words)
    (question,) = questions(words, tokenizer, len(words), network.config.max_text_len)
    high, wide = example.image.shape[:2]
    ids = torch.tensor([question.ids])
    return question, {
        "pixel_values": to_batch(example.image, *bound_size(wide, high, SIDE, 10 * SIDE), IMAGENET),
        "input_ids": ids,
        "token_type_ids": torch.zeros_like(ids),
        "attention_mask": torch.ones_like(ids),
    }


@torch.no_grad()
def _inputs(network: Any, layer: torch.nn.Module, given: Mapping[str, Any]) -> list[Tensor]:
    """Return the inputs of a layer while the network runs."""
    caught: list[Tensor] = []
    hook = layer.register_forward_pre_hook(lambda module, args: caught.append(args[0]))
    network(**given)
    hook.remove()
    return caught


@torch.no_grad()
def _solve(layer: torch.nn.Linear, before: Tensor, wanted: Tensor) -> None:
    """Set a layer's weights to map ``before`` to ``wanted``, row by row."""
    ones = torch.ones(len(before), 1)
    made = _solved(torch.cat([before, ones], 1), wanted).T.to(layer.weight)
    layer.weight.copy_(made[:, :-1])
    layer.bias.copy_(made[:, -1])


def _solved(rows: Tensor, wanted: Tensor) -> Tensor:
    """Return the minimum-norm least-squares solution x of rows @ x = wanted."""
    return torch.linalg.pinv(rows.double(), rtol=_DAMPED) @ wanted.double()
