// SPDX-License-Identifier: Apache-2.0

// Meshes of the shapes that the lit preview shows. All shapes use one coordinate system: x to the right, y up, and z
// toward a viewer who looks at the front. A mesh is an array of floats, kFloatsPerVertex for each vertex, and an
// array of indices of triangles.
//
// The texture coordinate u grows to the right and v grows up; both are 0 at the middle of the
// front. Their unit is the side of the plane, or the circumference of a round shape. A mesh also has
// two numbers that are valid after Surface.setTiling(1): `tiles` is the number of tiles along one
// unit of u, and `tileWidth` is the width of a tile in the units of positions. All mappings of the
// surfaces preserve angles, so that bubbles stay round and the slopes of the normal map stay
// correct.

// The floats of a vertex are: position (3), normal (3), tangent (3), texture coordinates (2),
// factor on the displacement (1), and a number that is 1 on walls and 0 elsewhere (1).
export const kFloatsPerVertex = 13;

const kCylinderRadius = 0.72;

class MeshBuilder {
    constructor(vertices, indices) {
        this.vertices = new Float32Array(vertices * kFloatsPerVertex);
        this.indices = new Uint32Array(indices);
        this.vertexCount = 0;
        this.indexCount = 0;
    }

    vertex({position, normal, tangent, uv, rise, wall = 0}) {
        this.vertices.set([...position, ...normal, ...tangent, ...uv, rise, wall], this.vertexCount * kFloatsPerVertex);
        return this.vertexCount++;
    }

    // Adds (columns + 1) x (rows + 1) vertices, made by vertexAt(a, b) for a and b from 0 to 1, and their triangles.
    // The triangles are counterclockwise if a points to the right and b points up. The diagonals alternate, so that
    // creases look the same in all directions.
    grid(columns, rows, vertexAt) {
        const first = this.vertexCount;
        for (let row = 0; row <= rows; ++row) {
            for (let column = 0; column <= columns; ++column) {
                this.vertex(vertexAt(column / columns, row / rows));
            }
        }
        for (let row = 0; row < rows; ++row) {
            for (let column = 0; column < columns; ++column) {
                const corner = first + row * (columns + 1) + column;
                const above = corner + columns + 1;
                const triangles = (row + column) % 2 === 0
                    ? [corner, corner + 1, above + 1, corner, above + 1, above]
                    : [corner, corner + 1, above, corner + 1, above + 1, above];
                this.indices.set(triangles, this.indexCount);
                this.indexCount += 6;
            }
        }
    }

    static sizeOfGrid(columns, rows) {
        return {vertices: (columns + 1) * (rows + 1), indices: columns * rows * 6};
    }
}

function builderFor(grids) {
    const sizes = grids.map(([columns, rows]) => MeshBuilder.sizeOfGrid(columns, rows));
    const sum = (key) => sizes.reduce((total, size) => total + size[key], 0);
    return new MeshBuilder(sum("vertices"), sum("indices"));
}

// A square slab with sides of length 2. Its upper face is displaced; its four walls end at the displaced border.
function plane(cells) {
    const kThickness = 0.06;
    const builder = builderFor([[cells, cells], ...Array(4).fill([cells, 1])]);
    const frame = {normal: [0, 0, 1], tangent: [1, 0, 0]};
    builder.grid(cells, cells, (a, b) => (
        {...frame, position: [2 * a - 1, 2 * b - 1, 0], uv: [a - 0.5, b - 0.5], rise: 1}));
    for (let side = 0; side < 4; ++side) {
        const cosine = [1, 0, -1, 0][side];
        const sine = [0, 1, 0, -1][side];
        builder.grid(cells, 1, (a, b) => {
            const x = cosine * (2 * a - 1) + sine;
            const y = sine * (2 * a - 1) - cosine;
            return {...frame, position: [x, y, (b - 1) * kThickness], uv: [x / 2, y / 2], rise: b, wall: 1};
        });
    }
    return {builder, tiles: 1, tileWidth: 2, cellsPerTurn: cells};
}

// A sphere of radius 1 in the Mercator projection, which preserves angles: bubbles become smaller toward the poles,
// but they are not pinched. The displacement shrinks with them.
function sphere(columns) {
    const rows = columns / 2;
    const kMaxLatitude = 89.6 / 180 * Math.PI;
    const builder = builderFor([[columns, rows]]);
    builder.grid(columns, rows, (a, b) => {
        const longitude = 2 * Math.PI * (a - 0.5);
        const latitude = Math.PI * (b - 0.5);
        const clamped = Math.min(Math.max(latitude, -kMaxLatitude), kMaxLatitude);
        const radius = Math.abs(b - 0.5) === 0.5 ? 0 : Math.cos(latitude);
        const normal = [radius * Math.sin(longitude), Math.sin(latitude), radius * Math.cos(longitude)];
        const tangent = [Math.cos(longitude), 0, -Math.sin(longitude)];
        const mercator = Math.asinh(Math.tan(clamped));
        return {position: normal, normal, tangent, uv: [a - 0.5, mercator / (2 * Math.PI)], rise: radius};
    });
    return {builder, tiles: 2, tileWidth: 2 * Math.PI / 2, cellsPerTurn: columns};
}

// An upright cylinder whose height is half its circumference, so that the tile fits without a cut. The displacement
// fades out at the edges, where the side meets the two flat ends.
function cylinder(columns) {
    const rows = columns / 2;
    const capRows = Math.round(columns / 4);
    const radius = kCylinderRadius;
    const half = radius * Math.PI / 2;
    const kEdge = 0.05;
    const circumference = 2 * Math.PI * radius;
    const builder = builderFor([[columns, rows], [columns, capRows], [columns, capRows]]);
    const riseAt = (distance) => Math.sqrt(1 - (1 - Math.min(distance / kEdge, 1)) ** 2);
    builder.grid(columns, rows, (a, b) => {
        const angle = 2 * Math.PI * (a - 0.5);
        const normal = [Math.sin(angle), 0, Math.cos(angle)];
        const y = half * (2 * b - 1);
        return {
            position: [radius * normal[0], y, radius * normal[2]],
            normal,
            tangent: [Math.cos(angle), 0, -Math.sin(angle)],
            uv: [a - 0.5, y / circumference],
            rise: riseAt(half - Math.abs(y)),
        };
    });
    for (const side of [1, -1]) {
        builder.grid(columns, capRows, (a, b) => {
            const angle = 2 * Math.PI * (a - 0.5);
            const distance = radius * (side > 0 ? 1 - b : b);
            const x = distance * Math.sin(angle);
            const z = distance * Math.cos(angle);
            return {
                position: [x, side * half, z],
                normal: [0, side, 0],
                tangent: [1, 0, 0],
                uv: [x / circumference, -side * z / circumference],
                rise: riseAt(radius - distance),
            };
        });
    }
    return {builder, tiles: 2, tileWidth: circumference / 2, cellsPerTurn: columns};
}

// `turnsAbout` is the axis about which the shape turns when the user drags to the side: "y" or "z".
// `tilt` is the default of the angle, in radians, by which the camera is above the middle of the
// front (below it, if the angle is negative); `tilts` are the limits of this angle. `radius` is the
// radius of a sphere that the view must contain. `sky` is the direction to the middle of the sky.
// `middle` is the height that is not displaced, as a fraction of the largest height; the edges of
// the cylinder meet only if it is 0. `lift` moves the image up if the camera is tilted, because the
// near side of the plane then looks larger than the far side.
const kDegree = Math.PI / 180;
const kAnyTilt = [-89 * kDegree, 89 * kDegree];
export const kShapes = {
    plane: {
        make: (cells) => plane(cells * 2 / 3), turnsAbout: "z", tilts: [-88 * kDegree, 0], tilt: -42 * kDegree,
        radius: 1.05, sky: [0, 0, 1], middle: 0.5, lift: 0.16,
    },
    sphere: {
        make: sphere, turnsAbout: "y", tilts: kAnyTilt, tilt: 12 * kDegree,
        radius: 1.1, sky: [0, 1, 0], middle: 0.5, lift: 0,
    },
    cylinder: {
        make: cylinder, turnsAbout: "y", tilts: kAnyTilt, tilt: 18 * kDegree,
        radius: 1.4, sky: [0, 1, 0], middle: 0, lift: 0,
    },
};

// Returns the mesh of the shape `name`: vertices, indices, tiles, tileWidth, and cellsPerTurn, the
// number of cells of the mesh along one unit of u. `cells`, a multiple of 6, is this number for
// round shapes; for the plane it is 2/3 of `cells`.
export function meshOf(name, cells) {
    const {builder, ...measures} = kShapes[name].make(cells);
    return {vertices: builder.vertices, indices: builder.indices, ...measures};
}
