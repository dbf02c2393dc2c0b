# SPDX-License-Identifier: Apache-2.0
"""Random presets, drawn from the JSON schema of `foamtex presets keys --json-schema`."""
import fnmatch
import json
import math

# Upper limits below the limits of the schema: for keys that decide how long a bake takes, and for the low end of a range.
LARGEST = {
    "foam.bubbles": 40, "foam.lloyd": 4, "frames.count": 5, "frames.time_step": 20, "frames.warm_up": 20,
    "frames.step_growth": 2, "loop.cycles": 6, "loop.growth": 8, "image.size": 40, "pressure.smoothing": 30,
    "pressure.flattening": 30, "dynamics.kappa": 1, "lit.samples": 3, "caustics.samples": 3, "event.frame": 6,
    "event.frames": 6, "event.time": 20, "event.bubble": 45, "event.count": 5, "pressure.low": -1e-3,
    "albedo.pressure_low": -1e-3,
}
# Lower limits above the limits of the schema: the high end of a range must be above its low end.
SMALLEST = {"pressure.high": 0, "albedo.pressure_high": 0, "image.size": 3}
# Gauss-Seidel is hundreds of times slower than Newton's method: such presets have short steps and wide tolerances.
LARGEST_GAUSS_SEIDEL = {"frames.time_step": 0.1, "frames.warm_up": 0.1, "frames.count": 2, "loop.cycles": 1}
SMALLEST_GAUSS_SEIDEL = {"foam.tolerance": 1e-4}
POLYGONS = ["disc", "rectangle", "POLYGON((0 0, 4 0, 4 3, 0 3))", "POLYGON((0 0, 4 0, 4 4, 0 4), (1 1, 2 1, 2 2, 1 2))",
            "POLYGON((-2 -2, 2 -2, 2 -1, -1 -1, -1 2, -2 2))"]
PATTERNS = ["out/{map}.####.png", "out/{map}.####.png", "out/{map}.%04d.exr", "out/{preset}_layers.@@@.exr", "out/{map}.png",
            "out/{map}.####.svg", "out/x.####.dxf", "out/x.####.pdf", "out/x.####.csv", "out/x.json", "out/{map}.####.stl",
            "out/x.####.glb"]
PACKINGS = ["ORM=occlusion,roughness,metallic", "P:16=height,1-roughness,normal.X,0.25", "C=albedo.R,albedo.G,albedo.B,opacity"]
TEXTS = {"foam.outline": POLYGONS, "foam.density": ["even", "gradient", "radial", "noise"], "albedo.picture": [""],
         "output.pattern": PATTERNS, "preset.description": ["", "foam of the caf\u00e9"],
         "output.pack": PACKINGS, "output.names": ["albedo=BaseColor", "height=H"],
         "preset.vary": ["foam.lloyd=0,1,4", "loop.amplitude=0.1..0.4", "dynamics.kappa=0..1:3"],
         "output.sheet_pattern": ["out/{preset}_sheet_{map}", "sheets/{map}"]}
# Values that these keys get in 70 % of all cases, because their other values exclude many values of other keys.
USUAL = {"loop.kind": '"none"', "frames.first": '"equilibrium"', "output.pattern": '"out/{map}.####.png"'}
SKIPPED = {"extends", "event"}
# Keys of every preset: without them, a bake takes too long.
ALWAYS = {"foam.bubbles", "foam.domain", "foam.tolerance", "frames.count", "frames.time_step", "image.size", "loop.cycles"}


class PresetMaker:
    """Makes presets from a schema."""

    def __init__(self, schema, random):
        self.schema, self.random = schema, random

    def make(self):
        """Returns the text of a preset."""
        self.chosen = {}
        density = self.random.choice([0.05, 0.2, 0.5, 1.0])
        lines = []
        for table, content in self.schema["properties"].items():
            if table not in SKIPPED:
                lines += [f"[{table}]", *self.table(table, content["properties"], density)]
        if self.chosen.get("loop.kind", USUAL["loop.kind"]) != USUAL["loop.kind"]:
            return "\n".join(lines) + "\n"  # most loops exclude events
        for _ in range(self.random.choice([0, 0, 0, 1, 2])):
            lines += ["[[event]]", *self.event()]
        return "\n".join(lines) + "\n"

    def table(self, table, keys, density):
        """Yields the lines of a table."""
        for name, key in keys.items():
            path = f"{table}.{name}"
            if path in ALWAYS or (self.random.random() < density and self.is_allowed(path, key)):
                self.chosen[path] = self.value(path, key)
                yield f"{name} = {self.chosen[path]}"

    def is_allowed(self, path, key):
        """Returns true if the keys chosen before allow the key, and rarely also if not, so that presets are rejected."""
        if self.random.random() < 0.002:
            return True
        if path == "loop.drift":
            return "drift" in self.chosen.get("loop.kind", "")
        condition = key.get("x-only-for")
        if condition:
            other = self.property_at(condition["key"])
            value = self.chosen.get(condition["key"], json.dumps(other.get("default")))
            return any(fnmatch.fnmatchcase(str(json.loads(value)), pattern) for pattern in condition["values"])
        return True

    def property_at(self, path):
        table, name = path.split(".")
        return self.schema["properties"][table]["properties"][name]

    def event(self):
        """Yields the lines of an event: one key gives its time, one key chooses bubbles or a position."""
        keys = self.random.choice(self.schema["properties"]["event"]["items"]["anyOf"])["properties"]
        when = self.random.choice(["frame", "frames", "frame", "time"])
        where = self.random.choice([name for name in ("at", "at", "bubble", "sides") if name in keys] or [None])
        chosen = {"kind", when, where} | ({"count"} if where == "sides" else set())
        groups = {"frame", "frames", "time", "at", "bubble", "sides", "count"}
        for name, key in keys.items():
            if name in chosen or (name not in groups and self.random.random() < 0.6):
                yield f"{name} = {self.value('event.' + name, key)}"

    def value(self, path, key):
        """Returns a value of a key as TOML."""
        if path in USUAL and self.random.random() < 0.7:
            return USUAL[path]
        if path in TEXTS:
            return f'"{self.random.choice(TEXTS[path])}"'
        if "anyOf" in key:
            return self.value(path, self.random.choice([one for one in key["anyOf"] if one.get("type") != "object"]))
        if "const" in key:
            return json.dumps(key["const"])
        if "enum" in key:
            return json.dumps(self.random.choice(key["enum"]))
        return {"array": self.array, "boolean": self.boolean, "string": self.string}.get(key["type"], self.number)(path, key)

    def array(self, path, key):
        length = self.random.randint(key.get("minItems", 0), key.get("maxItems", 5))
        items = [self.value(path, key["items"]) for _ in range(length)]
        if path in ("event.frames", "event.time"):
            items.sort(key=float)
        return "[" + ", ".join(dict.fromkeys(items) if key.get("uniqueItems") else items) + "]"

    def boolean(self, _path, _key):
        return self.random.choice(["true", "false"])

    def string(self, path, key):
        if "#" in key.get("pattern", ""):
            return f'"#{self.random.randrange(1 << 24):06x}"'
        raise ValueError(f"no strings for {path}: {key}")

    def limits(self, path, key):
        """Returns the smallest and the largest value of a key in a tiny bake."""
        low = max(key["minimum"], SMALLEST.get(path, -math.inf))
        high = min(key["maximum"], LARGEST.get(path, math.inf))
        if "gauss-seidel" in self.chosen.get("foam.solver", ""):
            return max(low, SMALLEST_GAUSS_SEIDEL.get(path, low)), min(high, LARGEST_GAUSS_SEIDEL.get(path, high))
        return low, high

    def number(self, path, key):
        low, high = self.limits(path, key)
        if self.random.random() < 0.1:
            number = self.random.choice([low, high])
        elif low > 0 and high > 100 * low:
            number = math.exp(self.random.uniform(math.log(low), math.log(high)))
        else:
            number = self.random.uniform(low, high)
        return str(round(number)) if key["type"] == "integer" else repr(float(number))
