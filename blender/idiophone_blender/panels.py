"""Where the settings are shown."""
import bpy


class ObjectPanel(bpy.types.Panel):
    bl_idname = "OBJECT_PT_idiophone"
    bl_label = "Idiophone"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "object"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.object is not None and context.object.type == "MESH"

    def draw_header(self, context: bpy.types.Context) -> None:
        self.layout.prop(context.object.idiophone, "is_body", text="")

    def draw(self, context: bpy.types.Context) -> None:
        settings = context.object.idiophone
        self.layout.use_property_split = True
        self.layout.active = settings.is_body
        own = ("young", "poisson", "density", "loss_factor") if settings.material == "own" else ()
        for name in ("material", *own, "size", "finite_elements"):
            self.layout.prop(settings, name)


class ScenePanel(bpy.types.Panel):
    bl_idname = "SCENE_PT_idiophone"
    bl_label = "Idiophone"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "scene"

    def draw(self, context: bpy.types.Context) -> None:
        self.layout.use_property_split = True
        for name in ("folder", "up_to", "damping", "ranks"):
            self.layout.prop(context.scene.idiophone, name)
        self.layout.operator("idiophone.compute", icon="PLAY_SOUND")


CLASSES = (ObjectPanel, ScenePanel)


def register() -> None:
    for part in CLASSES:
        bpy.utils.register_class(part)


def unregister() -> None:
    for part in reversed(CLASSES):
        bpy.utils.unregister_class(part)
