"""Decoding of untrusted pictures: photos, uploads, depth maps, textures and server responses.

``decode`` checks a picture's header against limits (:mod:`.headers`, :mod:`.limits`), decodes the
picture in a child process (:mod:`.pixels`) and returns an array. Callers choose the exception type.
"""

from .decoder import decode as decode
from .decoder import decode_png as decode_png
from .headers import DamagedHeader as DamagedHeader
from .headers import Format as Format
from .headers import PictureHeader as PictureHeader
from .headers import format_of as format_of
from .headers import png_size as png_size
from .limits import PictureLimits as PictureLimits
from .limits import read_header as read_header
from .picture import DecodedPicture as DecodedPicture
from .picture import Form as Form
