#!/usr/bin/env python3
"""Blender's Cycles before the judge (docs/gallery.md). It begins as a plain program, and calls Blender with itself.

    zproof run room --renderer 'python3 examples/gallery/blender_render.py {scene} {camera} {out}' --precision cycles
"""
import os
import sys
import tempfile

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [here, os.path.join(here, '..', 'contract')]
import in_blender  # noqa: E402
import zproof_contract as contract  # noqa: E402


def mesh_of(bpy, triangles):
    """One mesh; each face knows its own id as a float, which is exact below 2^24."""
    mesh = bpy.data.meshes.new('triangles')
    corners = [corner for triangle in triangles for corner in triangle]
    mesh.from_pydata(corners, [], [(i, i + 1, i + 2) for i in range(0, len(corners), 3)])
    of_faces = mesh.attributes.new('triangle', 'FLOAT', 'FACE')
    of_faces.data.foreach_set('value', [float(i) for i in range(len(triangles))])
    material = bpy.data.materials.new('ids')
    material.use_nodes = True
    nodes = material.node_tree.nodes
    attribute, output = nodes.new('ShaderNodeAttribute'), nodes.new('ShaderNodeOutputAOV')
    attribute.attribute_name, output.name = 'triangle', 'id'
    material.node_tree.links.new(attribute.outputs['Fac'], output.inputs['Value'])
    mesh.materials.append(material)
    return mesh


def set_camera(bpy, mathutils, camera):
    """Blender's own camera: a square sensor fits the longer side, and shifts are shares of it."""
    scene, data = bpy.context.scene, bpy.data.cameras.new('camera')
    left, right, bottom, top = (camera.window[key] for key in ('left', 'right', 'bottom', 'top'))
    per_px = (right - left) / camera.width
    longer = per_px * max(camera.width, camera.height)
    if abs((top - bottom) / camera.height / per_px - 1) > 1e-6 or any(camera.shear):
        sys.exit('projections: Cycles has no oblique ones and no pixels that are not square here')
    data.type = 'PERSP' if camera.perspective else 'ORTHO'
    data.sensor_fit, data.sensor_width, data.lens = 'AUTO', longer, 1
    data.ortho_scale = longer
    data.shift_x, data.shift_y = (left + right) / 2 / longer, (bottom + top) / 2 / longer
    data.clip_start, data.clip_end = camera.near, min(camera.far, 3e38)
    scene.camera = bpy.data.objects.new('camera', data)
    columns = zip(camera.right, camera.up, camera.back, camera.eye)
    scene.camera.matrix_world = mathutils.Matrix([*columns, (0, 0, 0, 1)])
    scene.collection.objects.link(scene.camera)


def set_up_cycles(bpy, camera, folder):
    scene, layer = bpy.context.scene, bpy.context.view_layer
    scene.render.engine = 'CYCLES'
    scene.render.resolution_x, scene.render.resolution_y = camera.width, camera.height
    scene.cycles.samples, scene.cycles.use_adaptive_sampling, scene.cycles.use_denoising = 1, False, False
    scene.cycles.filter_width, scene.cycles.max_bounces = 0.01, 0
    layer.use_pass_z = True
    layer.aovs.add().name = 'id'
    layer.aovs['id'].type = 'VALUE'
    scene.render.image_settings.file_format, scene.render.image_settings.color_depth = 'OPEN_EXR_MULTILAYER', '32'
    scene.render.filepath = os.path.join(folder, 'frame.exr')


def read_back(folder, camera):
    """The two passes of Blender's file."""
    import numpy as np
    import OpenImageIO
    image = OpenImageIO.ImageBuf(os.path.join(folder, 'frame.exr'))
    values = image.get_pixels(OpenImageIO.FLOAT)
    plane = {name.split('.', 1)[1]: values[:, :, i] for i, name in enumerate(image.spec().channelnames)}
    is_background = plane['Depth.Z'] >= 1e10
    frame = contract.Frame(camera.width, camera.height)
    frame.id = np.where(is_background, contract.BACKGROUND, plane['id.X'].astype(np.int64)).astype(np.uint32)
    frame.depth = np.where(is_background, np.inf, plane['Depth.Z']).astype(np.float32)
    return frame


def render_in_blender(scene, camera_file, folder):
    import bpy
    import mathutils
    camera = contract.Camera(camera_file)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    mesh = mesh_of(bpy, contract.read_triangles(scene))
    bpy.context.scene.collection.objects.link(bpy.data.objects.new('triangles', mesh))
    set_camera(bpy, mathutils, camera)
    set_up_cycles(bpy, camera, folder)
    bpy.ops.render.render(write_still=True)


if in_blender.IS_HERE:
    render_in_blender(*in_blender.arguments())
else:
    scene_file, camera_file, out = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        in_blender.run(os.path.abspath(__file__), scene_file, camera_file, folder)
        contract.write_exr(out, read_back(folder, contract.Camera(camera_file)))
