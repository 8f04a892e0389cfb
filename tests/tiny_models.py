"""Tiny instances of transformers' classes with random weights, saved like pinned models.

A tiny model lies where its pin says the real one would, so that all of the backend but the values
of the weights is real.
"""

from pathlib import Path
from typing import Any

import torch
import transformers  # its classes are imported where they are named
from safetensors.torch import save_file
from tokenizers import Tokenizer, models, normalizers, pre_tokenizers, processors

from generator.backends.huggingface.weights.pins import WEIGHTS, pins, snapshot

LETTERS = "abcdefghijklmnopqrstuvwxyz"
MARKS = {"[PAD]": 0, "[UNK]": 100, "[CLS]": 101, "[SEP]": 102, ".": 1012, "?": 1029}
"""Tokens that Grounding DINO knows by their number, as in BERT's vocabulary."""


def save_all(folder: Path) -> Path:
    """Save a tiny model for every pin; return the folder."""
    torch.manual_seed(0)
    made = {
        "grounding-dino-base": grounding_dino(),
        "grounding-dino-tiny": grounding_dino(),
        "sam2": sam2(),
        "sam3": sam3(),
        "dinov2": dinov2(),
        "clip": clip(),
    }
    for name, model in made.items():
        home = snapshot(pins()[name], folder)
        model.save_pretrained(home)
        if "tokenizer.json" in pins()[name].files:
            letters_tokenizer().save(str(home / "tokenizer.json"))
    return folder


def letters_tokenizer() -> Tokenizer:
    """Return a BERT tokenizer that knows only single letters: "mug" is m, ##u, ##g."""
    vocabulary = dict(MARKS)
    for k, letter in enumerate(LETTERS):
        vocabulary[letter], vocabulary[f"##{letter}"] = 200 + k, 300 + k
    tokenizer = Tokenizer(models.WordPiece(vocabulary, unk_token="[UNK]"))
    tokenizer.normalizer = normalizers.BertNormalizer()
    tokenizer.pre_tokenizer = pre_tokenizers.BertPreTokenizer()
    tokenizer.post_processor = processors.TemplateProcessing(
        "[CLS] $A [SEP]", special_tokens=[("[CLS]", 101), ("[SEP]", 102)]
    )
    return tokenizer


def grounding_dino(**others: Any) -> Any:
    """Return a Grounding DINO with some thousands of weights and ``others`` settings."""
    backbone = transformers.SwinConfig(
        image_size=64, embed_dim=8, depths=[1, 1, 1, 1], num_heads=[1, 1, 2, 2], window_size=4,
        out_indices=[2, 3, 4],
    )  # fmt: skip
    text = transformers.BertConfig(
        vocab_size=1030, hidden_size=16, num_hidden_layers=1, num_attention_heads=2,
        intermediate_size=16,
    )  # fmt: skip
    settings = {
        "d_model": 32, "num_queries": 12, "encoder_layers": 1, "decoder_layers": 2,
        "encoder_ffn_dim": 16, "decoder_ffn_dim": 16, "encoder_attention_heads": 2,
        "decoder_attention_heads": 2, "max_text_len": 48,
    }  # fmt: skip
    return transformers.GroundingDinoForObjectDetection(transformers.GroundingDinoConfig(
        backbone_config=backbone, text_config=text, **{**settings, **others}
    ))  # fmt: skip


def sam2(side: int = 64, hidden_size: int = 32, width: int = 8, **decoder: Any) -> Any:
    """Return a small SAM 2 for pictures of ``side`` pixels, a multiple of 16.

    ``width`` is that of its first stage, ``decoder`` more settings of its mask decoder.
    """
    hiera = {
        "model_type": "sam2_hiera_det_model", "hidden_size": width, "num_attention_heads": 1,
        "image_size": [side, side],
        "blocks_per_stage": [1, 1, 2, 1],
        "embed_dim_per_stage": [width, 2 * width, 4 * width, 8 * width],
        "num_attention_heads_per_stage": [1, 1, 2, 2], "global_attention_blocks": [3],
        "window_positional_embedding_background_size": [4, 4],
    }  # fmt: skip
    vision = {
        "backbone_config": hiera,
        "backbone_channel_list": [8 * width, 4 * width, 2 * width, width],
        "fpn_hidden_size": hidden_size,
        "backbone_feature_sizes": [[side // n, side // n] for n in (4, 8, 16)],
    }  # fmt: skip
    prompts = {
        "hidden_size": hidden_size, "image_size": side, "patch_size": 16, "mask_input_channels": 4
    }  # fmt: skip
    decoder = {
        "hidden_size": hidden_size, "mlp_dim": 16, "num_hidden_layers": 1, "num_attention_heads": 2,
        "iou_head_hidden_dim": 16, **decoder,
    }  # fmt: skip
    return transformers.Sam2Model(transformers.Sam2Config(
        vision_config=vision, prompt_encoder_config=prompts, mask_decoder_config=decoder
    ))  # fmt: skip


def sam3() -> Any:
    """Return a SAM 3 with some thousands of weights, for pictures of 56 pixels."""
    vit = {
        "model_type": "sam3_vit_model", "hidden_size": 16, "intermediate_size": 16,
        "num_hidden_layers": 1,
        "num_attention_heads": 2, "image_size": 56, "pretrain_image_size": 28, "window_size": 2,
        "global_attn_indexes": [0],
    }  # fmt: skip
    small = {
        "hidden_size": 16, "num_layers": 1, "num_attention_heads": 2, "intermediate_size": 16
    }  # fmt: skip
    text = {
        "vocab_size": 1030, "hidden_size": 16, "intermediate_size": 16, "num_hidden_layers": 1,
        "num_attention_heads": 2, "projection_dim": 16, "max_position_embeddings": 32,
        "bos_token_id": 101, "eos_token_id": 102,
    }  # fmt: skip
    return transformers.Sam3Model(transformers.Sam3Config(
        vision_config={"backbone_config": vit, "fpn_hidden_size": 16},
        text_config=text,
        geometry_encoder_config=small,
        detr_encoder_config=small,
        detr_decoder_config=small | {"num_queries": 6},
        mask_decoder_config={"hidden_size": 16, "num_upsampling_stages": 3,
                             "num_attention_heads": 2},
    ))  # fmt: skip


def dinov2(step: int = 14) -> Any:
    return transformers.Dinov2Model(transformers.Dinov2Config(
        hidden_size=32, num_hidden_layers=2, num_attention_heads=2, image_size=56, patch_size=step
    ))  # fmt: skip


def clip() -> Any:
    text = transformers.CLIPTextConfig(
        vocab_size=1030, hidden_size=16, intermediate_size=16, num_hidden_layers=1,
        num_attention_heads=2, bos_token_id=101, eos_token_id=102,
    )  # fmt: skip
    vision = transformers.CLIPVisionConfig(
        hidden_size=16, intermediate_size=16, num_hidden_layers=1, num_attention_heads=2,
        image_size=224, patch_size=56,
    )  # fmt: skip
    return transformers.CLIPModel(transformers.CLIPConfig(
        text_config=text.to_dict(), vision_config=vision.to_dict(), projection_dim=8
    ))  # fmt: skip


def save_for_video(folder: Path) -> Path:
    """Save SAM 2 and SAM 3 with the parts for videos, as they are published."""
    torch.manual_seed(0)
    still = sam2().config.to_dict()
    parts = {k: still[f"{k}_config"] for k in ("vision", "prompt_encoder", "mask_decoder")}
    transformers.Sam2VideoModel(transformers.Sam2VideoConfig(
        **{f"{k}_config": v for k, v in parts.items()}, memory_attention_hidden_size=32,
        memory_attention_num_layers=1, memory_attention_feed_forward_hidden_size=16,
        memory_attention_rope_feat_sizes=[4, 4], memory_encoder_hidden_size=32,
        memory_encoder_output_channels=16, mask_downsampler_embed_dim=32,
        memory_fuser_num_layers=1, memory_fuser_embed_dim=32, memory_fuser_intermediate_dim=16,
    )).save_pretrained(snapshot(pins()["sam2"], folder))  # fmt: skip
    detector, home = sam3(), snapshot(pins()["sam3"], folder)
    home.mkdir(parents=True)
    transformers.Sam3VideoConfig(detector_config=detector.config.to_dict()).save_pretrained(home)
    weights = {f"detector_model.{k}": v for k, v in detector.state_dict().items()}
    save_file(weights | {"tracker_model.a": torch.zeros(1)}, home / WEIGHTS, {"format": "pt"})
    letters_tokenizer().save(str(home / "tokenizer.json"))
    return folder
