# SPDX-License-Identifier: Apache-2.0
import unittest

import support
from model.fault import Fault
from model.plan import Channel, plan_material
from model.reader import read_bake


class PlanTest(support.FolderTest):
    def plan(self, maps, choose=None, cyclic=None, **members):
        baked = support.make_set(maps, **members)
        self.write_images(baked)
        return plan_material(read_bake(self.write_manifest(baked)), choose, cyclic)


class ChoiceOfMaps(PlanTest):
    def test_color_is_albedo_before_others(self):
        for maps, color in ((["lit", "albedo"], "albedo"), (["maze", "lit"], "lit"), (["contour", "maze"], "maze"),
                            (["contour", "thin_film"], "thin_film"), (["height", "contour"], "contour")):
            self.assertEqual(self.plan(maps).color.name, color)

    def test_every_role(self):
        plan = self.plan(["albedo", "emission", "normal", "roughness", "metallic", "occlusion", "opacity", "height"])
        self.assertEqual({name: source.images.name for name, source in plan.numbers.items()},
                         {name: name for name in ("roughness", "metallic", "occlusion", "opacity", "height")})
        self.assertEqual((plan.color.name, plan.emission.name, plan.normal.images.name),
                         ("albedo", "emission", "normal"))
        self.assertEqual(len(plan.used_images()), 8)

    def test_chosen_maps(self):
        plan = self.plan(["albedo", "lit", "normal"], choose=["lit"])
        self.assertEqual((plan.color.name, plan.normal), ("lit", None))
        with self.assertRaisesRegex(Fault, "no map 'x'; the maps are albedo, lit"):
            self.plan(["albedo", "lit"], choose=["x"])

    def test_no_usable_map(self):
        with self.assertRaisesRegex(Fault, "no map that a material uses.*chosen: id, motion"):
            self.plan(["id", "motion"])


class Alpha(PlanTest):
    def test_of_the_color_map(self):
        straight = support.map_entry("albedo", alpha="straight")
        premultiplied = support.map_entry("albedo", alpha="premultiplied")
        for maps, expected in ((["albedo"], False), ([straight], True), ([straight, "opacity"], False),
                               ([premultiplied], True), ([premultiplied, "opacity"], True)):
            self.assertEqual(self.plan(maps).alpha_of_color, expected, maps)


class NormalDirection(PlanTest):
    def test_comes_from_the_name_or_the_conventions(self):
        for name, y, down in (("normal", "up", False), ("normal", "down", True), ("normal_gl", "down", False),
                              ("normal_dx", "up", True)):
            self.assertEqual(self.plan([name], conventions={"normal_y": y}).normal.y_down, down, (name, y))

    def test_numbers_are_signed(self):
        self.assertFalse(self.plan(["normal"]).normal.signed)
        self.assertTrue(self.plan([support.map_entry("normal", type="half")]).normal.signed)


class Packed(PlanTest):
    def test_occlusion_roughness_metallic(self):
        plan = self.plan([support.map_entry("orm", packed=["occlusion", "roughness", "metallic"])])
        orm = plan.used_images()[0]
        self.assertEqual(plan.numbers, {"occlusion": Channel(orm, 0), "roughness": Channel(orm, 1),
                                        "metallic": Channel(orm, 2)})

    def test_mask_map_of_unity(self):
        plan = self.plan([support.map_entry("mask", packed=["metallic", "occlusion", "0", "1-roughness"])])
        mask = plan.used_images()[0]
        self.assertEqual(plan.numbers, {"metallic": Channel(mask, 0), "occlusion": Channel(mask, 1),
                                        "roughness": Channel(mask, 3, inverted=True)})

    def test_constant_metal(self):
        plan = self.plan([support.map_entry("orm", packed=["occlusion", "roughness", "0"])])
        self.assertEqual(plan.numbers["metallic"], 0.0)

    def test_a_map_of_its_own_comes_first(self):
        plan = self.plan([support.map_entry("orm", packed=["occlusion", "roughness", "0"]), "roughness"])
        self.assertEqual(plan.numbers["roughness"].images.name, "roughness")

    def test_colors_with_a_number_in_alpha(self):
        packed = support.map_entry("bcr", color_space="sRGB", packed=["albedo.R", "albedo.G", "albedo.B", "1-roughness"])
        plan = self.plan([packed, "lit"])
        self.assertEqual(plan.color.name, "bcr")
        self.assertEqual(plan.numbers, {"roughness": Channel(plan.color, 3, inverted=True)})
        self.assertFalse(plan.alpha_of_color)

    def test_codes_of_packed_normals_are_not_signed(self):
        packed = support.map_entry("nh", type="float", packed=["normal.X", "normal.Y", "height"])
        self.assertFalse(self.plan([packed]).normal.signed)

    def test_normals(self):
        for packed, indices in ((["normal.X", "normal.Y", "height"], [0, 1]),
                                (["roughness", "normal.Y", "0", "normal.X"], [3, 1]),
                                (["normal.X", "normal.Y", "normal.Z"], [0, 1, 2])):
            normal = self.plan([support.map_entry("nh", packed=packed)], conventions={"normal_y": "down"}).normal
            self.assertEqual([channel.index for channel in normal.channels], indices)
            self.assertTrue(normal.y_down)

    def test_unused_image(self):
        plan = self.plan(["albedo", support.map_entry("x", packed=["id", "age", "0"])])
        self.assertEqual([images.name for images in plan.used_images()], ["albedo"])


class Frames(PlanTest):
    def test_loop(self):
        plan = self.plan(["albedo", "normal"])
        self.assertEqual((plan.first, plan.count, plan.cyclic), (1, 4, True))
        self.assertEqual(set(plan.sequences), {"albedo", "normal"})

    def test_a_part_of_a_loop_does_not_repeat(self):
        plan = self.plan(["albedo"], frames=range(3, 6))
        self.assertEqual((plan.first, plan.count, plan.cyclic), (3, 3, False))
        self.assertTrue(self.plan(["albedo"], frames=range(3, 6), cyclic=True).cyclic)

    def test_a_foam_without_a_loop_does_not_repeat(self):
        self.assertFalse(self.plan(["albedo"], period=0).cyclic)

    def test_any_period_of_a_loop_repeats(self):
        self.assertTrue(self.plan(["albedo"], frames=range(3, 7)).cyclic)

    def test_rejects_a_step(self):
        with self.assertRaisesRegex(Fault, "map albedo: the frames 1-7x2 are not consecutive"):
            self.plan(["albedo"], frames=range(1, 8, 2))

    def test_rejects_maps_with_different_frames(self):
        baked = support.make_set(["albedo", "normal"])
        baked["files"].pop()
        self.write_images(baked)
        with self.assertRaisesRegex(Fault, "albedo and normal have different frames, 1-4 and 1-3"):
            plan_material(read_bake(self.write_manifest(baked)))

    def test_frames_of_unused_maps_do_not_matter(self):
        baked = support.make_set(["albedo", "id"])
        baked["files"] = [file for file in baked["files"] if file["maps"] == ["albedo"] or file["frame"] == 2]
        self.write_images(baked)
        self.assertEqual(plan_material(read_bake(self.write_manifest(baked))).count, 4)

    def test_rejects_missing_files(self):
        baked = support.make_set(["albedo"])
        self.write_images(baked)
        (self.folder / "a_albedo.0003.png").unlink()
        with self.assertRaisesRegex(Fault, "albedo.0003.png' is missing"):
            plan_material(read_bake(self.write_manifest(baked)))

    def test_rejects_layers(self):
        baked = support.make_set(["albedo", "normal"])
        for file in baked["files"]:
            file["maps"] = ["albedo", "normal"]
        self.write_images(baked)
        with self.assertRaisesRegex(Fault, "several maps.*bake with {map} in the file name"):
            plan_material(read_bake(self.write_manifest(baked)))


class Sheets(support.FolderTest):
    def plan(self, numbers, frames, closes):
        book = {"format": "foamtex-flipbook", "version": 1, "preset": "a", "seed": 1, "frames": frames,
                "frame_numbers": numbers, "frames_per_second": 12, "tiles": True, "loop": {"closes": closes},
                "conventions": {"normal_y": "up"},
                "layout": {"frame_size": [64, 64], "columns": 2,
                           "uv": {"cell": [0.5, 0.5], "inset": [0, 0], "frame": [0.5, 0.5]}},
                "images": [{"file": "a_sheet_albedo.png", "map": "albedo"}]}
        return plan_material(read_bake(self.write_json("a_sheet.json", book)))

    def test_frames(self):
        for numbers, frames, closes, expected in (("1-4", 4, True, (1, 4, True)), ("3-6", 4, False, (3, 4, False)),
                                                  ("1-7x2", 4, True, (1, 4, True)), ("3-9x2", 4, True, (1, 4, True))):
            plan = self.plan(numbers, frames, closes)
            self.assertEqual((plan.first, plan.count, plan.cyclic), expected, numbers)


if __name__ == "__main__":
    unittest.main()
