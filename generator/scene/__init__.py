"""The immutable data types of the pipeline, from a prompt or an image to a scene.

Frames and units of the whole project
-------------------------------------
SI metres, kilograms, radians, seconds; quaternions are ``wxyz`` as in MuJoCo.

*World (table) frame*: right-handed, origin on the floor under the table's centre, +x right and
+y away *as seen in the reference image*, +z up. Yaw turns about +z, counter-clockwise seen from
above.

*Canonical object frame*: +z up, with the mesh normalised to the unit box ``[-0.5, 0.5]^3``.
``scale`` is the object's *extent* along its own axes in metres; ``translation`` is the *centre of
its bounding box*.

*Camera axes*: x right, y down, z forward. A ``View`` with azimuth 0 looks along +y; a positive
azimuth moves the camera towards +x. Elevation is measured from the horizon; ``fov`` is the vertical
field of view.

*Robot base frame*, defined in ``tabletopgen_env.world.world``: origin at the robot's base, x
forward, z up.

*Images* are ``uint8`` RGB, row 0 at the top. *Pixel boxes* are ``(x0, y0, x1, y1)``; the right and
bottom bounds are exclusive. *Pixel coordinates*: (0, 0) is the top-left corner of the image, so
pixel centres have half-integer coordinates; only ``Intrinsics`` places the centre of the first
pixel at (0, 0), as OpenCV and ROS do. In the *top view* u (right) is world +x and v (down) is world
-y. *Texture coordinates*: u points right and v points up (Wavefront OBJ), so v = 1 at row 0.
"""

from tabletop_objects.values import ConvexPart as ConvexPart
from tabletop_objects.values import Mesh as Mesh
from tabletop_objects.values import Model as Model
from tabletop_objects.values import PartKind as PartKind
from tabletop_objects.values import Physics as Physics
from tabletop_objects.values import Slot as Slot
from tabletop_objects.values import frozen_array as frozen_array

from .outcomes import held_relations as held_relations
from .outcomes import hold_supports as hold_supports
from .picture import USUAL_VIEW as USUAL_VIEW
from .picture import Detection as Detection
from .picture import Instance as Instance
from .picture import Intrinsics as Intrinsics
from .picture import Reference as Reference
from .picture import TopView as TopView
from .picture import View as View
from .plan import TABLE as TABLE
from .plan import Density as Density
from .plan import GroupKind as GroupKind
from .plan import OutlineKind as OutlineKind
from .plan import PlannedGroup as PlannedGroup
from .plan import PlannedObject as PlannedObject
from .plan import PlannedTable as PlannedTable
from .plan import Relation as Relation
from .plan import RelationKind as RelationKind
from .plan import ScenePlan as ScenePlan
from .report import MAX_LEAN as MAX_LEAN
from .report import Failure as Failure
from .report import FailureKind as FailureKind
from .report import RelationOutcome as RelationOutcome
from .report import Report as Report
from .result import Edit as Edit
from .result import EditKind as EditKind
from .result import LayoutBox as LayoutBox
from .result import Object as Object
from .result import Placement as Placement
from .result import Pose as Pose
from .result import Provenance as Provenance
from .result import Rotation as Rotation
from .result import Scene as Scene
from .result import Stacking as Stacking
from .result import Table as Table
from .sizes import Proportions as Proportions
from .sizes import SizePrior as SizePrior
