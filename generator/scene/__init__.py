"""The nouns of the pipeline: frozen values that flow from a text or an image to a scene.

Frames and units, stated once for the whole project
---------------------------------------------------
SI metres, kilograms, radians, seconds; quaternions are ``wxyz`` as in MuJoCo.

*World (table) frame*: right-handed, origin on the floor under the table's centre, +x right and
+y away *as seen in the reference image*, +z up. Yaw turns about +z, counter-clockwise seen from
above.

*Canonical object frame*: +z up, the mesh normalised to the unit box ``[-0.5, 0.5]^3``. ``scale``
is the object's *extent* along its own axes in metres; ``translation`` is the *centre of its box*.

*Images* are ``uint8`` RGB, row 0 at the top. *Pixel boxes* are ``(x0, y0, x1, y1)``, right and
bottom exclusive. *Texture coordinates* have u to the right and v upwards (Wavefront OBJ), so
texture row 0 is v = 1.
"""

from .arrays import frozen_array
from .model import ConvexPart, Mesh, Model, PartKind, Physics, SizePrior
from .picture import USUAL_VIEW, Detection, Instance, Intrinsics, Reference, TopView, View
from .plan import (
    TABLE,
    GroupKind,
    OutlineKind,
    PlannedGroup,
    PlannedObject,
    PlannedTable,
    Relation,
    RelationKind,
    ScenePlan,
)
from .result import (
    Edit,
    EditKind,
    LayoutBox,
    Object,
    Placement,
    Pose,
    Provenance,
    RelationOutcome,
    Report,
    Rotation,
    Scene,
    Stacking,
    Table,
    names_in,
)

__all__ = [
    "TABLE",
    "USUAL_VIEW",
    "ConvexPart",
    "Detection",
    "Edit",
    "EditKind",
    "GroupKind",
    "Instance",
    "Intrinsics",
    "LayoutBox",
    "Mesh",
    "Model",
    "Object",
    "OutlineKind",
    "PartKind",
    "Physics",
    "Placement",
    "PlannedGroup",
    "PlannedObject",
    "PlannedTable",
    "Pose",
    "Provenance",
    "Reference",
    "Relation",
    "RelationKind",
    "RelationOutcome",
    "Report",
    "Rotation",
    "Scene",
    "ScenePlan",
    "SizePrior",
    "Stacking",
    "Table",
    "TopView",
    "View",
    "frozen_array",
    "names_in",
]
