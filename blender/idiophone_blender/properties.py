"""What the user says of objects and of the scene."""
import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, PointerProperty, StringProperty

SHIPPED = ("steel", "aluminium", "brass", "bronze", "copper", "glass", "alumina", "porcelain", "concrete", "acrylic", "nylon",
           "rubber")  # the isotropic materials of docs/use/materials.md


class ObjectSettings(bpy.types.PropertyGroup):
    """A physical material makes an object a body."""

    is_body: BoolProperty(name="Sounds", description="Idiophone computes the motion and the sound of this object")
    material: EnumProperty(name="Material", items=[(name, name.capitalize(), "") for name in SHIPPED] +
                           [("own", "Own", "A material of these numbers")])
    young: FloatProperty(name="Young's modulus (GPa)", default=70, min=1e-3, max=2000)
    poisson: FloatProperty(name="Poisson's ratio", default=0.3, min=0, max=0.49)
    density: FloatProperty(name="Density (kg/m³)", default=2500, min=1, max=30000)
    loss_factor: FloatProperty(name="Loss factor", default=1e-3, min=0, max=0.3, precision=5)
    size: FloatProperty(name="Element size (m)", default=0, min=0,
                        description="The largest element of its mesh; 0: a fifth of its longest side")
    finite_elements: BoolProperty(name="Finite elements", description="It moves by its finite elements, which takes much longer, "
                                  "instead of by its modes")


class SceneSettings(bpy.types.PropertyGroup):
    folder: StringProperty(name="Folder", default="//idiophone", subtype="DIR_PATH", description="Deck, meshes and results")
    up_to: FloatProperty(name="Modes up to (Hz)", default=12000, min=100, max=20000)
    damping: FloatProperty(name="Contact damping (s)", default=1e-7, min=0, max=1e-3, precision=8)
    ranks: IntProperty(name="Ranks", default=1, min=1, max=64, description="Processes that compute at the same time")


CLASSES = (ObjectSettings, SceneSettings)


def register() -> None:
    for part in CLASSES:
        bpy.utils.register_class(part)
    bpy.types.Object.idiophone = PointerProperty(type=ObjectSettings)
    bpy.types.Scene.idiophone = PointerProperty(type=SceneSettings)


def unregister() -> None:
    del bpy.types.Object.idiophone, bpy.types.Scene.idiophone
    for part in reversed(CLASSES):
        bpy.utils.unregister_class(part)
