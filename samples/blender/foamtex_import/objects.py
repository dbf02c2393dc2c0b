# SPDX-License-Identifier: Apache-2.0
"""The object that gets an imported material."""
import math


def active_mesh(context):
    """Returns the active object if it can show a material and has texture coordinates, otherwise None."""
    found = context.active_object
    return found if found and found.type == "MESH" and found.data.uv_layers.active else None


def tile_size_of(found):
    """Returns the mean width of a tile on a mesh, in units of the object, or 1 if the mesh has no area.

    It is the square root of the ratio of the area of the faces to their area in texture coordinates.
    """
    mesh = found.data
    area = sum(polygon.area for polygon in mesh.polygons)
    area_of_uv = sum(_uv_area(mesh, polygon) for polygon in mesh.polygons)
    return math.sqrt(area / area_of_uv) if area > 0 and area_of_uv > 0 else 1.0


def _uv_area(mesh, polygon):
    corners = [mesh.uv_layers.active.data[index].uv for index in polygon.loop_indices]
    following = corners[1:] + corners[:1]
    return abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(corners, following))) / 2


def assign(found, material):
    """Replaces the active material of an object."""
    if found.material_slots:
        found.active_material = material
    else:
        found.data.materials.append(material)
