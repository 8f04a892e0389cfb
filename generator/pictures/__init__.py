"""The decoder of every foreign picture: photos, uploads, depth maps, textures, servers' answers.

``decode`` reads a picture's header within limits (:mod:`.headers`, :mod:`.limits`), has a child
process decode it (:mod:`.pixels`), and returns a finished array. Each caller names the error to
raise.
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
