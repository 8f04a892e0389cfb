"""Settings of the documentation site: ``sphinx-build -c docs/site docs build/docs``."""

from __future__ import annotations

import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path[:0] = [str(HERE), str(HERE.parents[1])]  # this folder's modules, and the checkout

project = "TabletopGen"
author = "The TabletopGen authors"
project_copyright = author

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "generated_pages",
    "live_scenes",
]
exclude_patterns = ["site"]
language = "en"
suppress_warnings = ["ref.python"]  # annotations that name one of several classes of a name

myst_heading_anchors = 4
myst_enable_extensions = ["colon_fence"]

autosummary_generate = False  # modules are on pages of their own: nothing is written into docs/
autodoc_default_options = {"members": True}
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_preserve_defaults = True
napoleon_numpy_docstring = False
napoleon_use_ivar = True
python_maximum_signature_line_length = 88
toc_object_entries_show_parents = "hide"

smartquotes = False  # options begin with two dashes

html_theme = "furo"
html_title = "TabletopGen"
html_theme_options = {"top_of_page_buttons": []}
