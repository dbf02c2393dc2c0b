// SPDX-License-Identifier: Apache-2.0

// Checks scenes of OpenUSD with a parser of another author.

import {readFileSync} from "node:fs";
import {PACKAGES} from "./packages.mjs";

const {parse} = await import(`${PACKAGES}/@kroxilon/usda-parser/lib/usda-parser.peggy.js`);

// Returns the attributes of every prim, by its path: {"/lava/material/surface": {"info:id": "UsdPreviewSurface", ...}, ...}.
function primsOf(statements, path = "") {
    const prims = {};
    for (const {type, name, statements: children} of statements) {
        if (type === "definition") {
            const own = children.filter((child) => child.type === "declaration");
            prims[`${path}/${name}`] = Object.fromEntries(own.map(({reference, value}) => [reference, value]));
            Object.assign(prims, primsOf(children, `${path}/${name}`));
        }
    }
    return prims;
}

function fail(scene, problem, value) {
    throw new Error(`${scene}: ${problem}: ${JSON.stringify(value)}`);
}

// Throws unless every connection leads to an output of a prim.
function checkConnections(scene, prims) {
    let connections = 0;
    for (const [path, attributes] of Object.entries(prims)) {
        for (const [name, value] of Object.entries(attributes)) {
            if (name.endsWith(".connect")) {
                ++connections;
                if (!(value.field in (prims[value.importPath] ?? {}))) {
                    fail(scene, `${path}.${name} leads nowhere`, value);
                }
            }
        }
    }
    return connections;
}

// Returns the files of a texture of two frames. Throws if its time samples are not those of the frames 1 and 3.
function filesOf(scene, texture) {
    const samples = texture["inputs:file.timeSamples"]?.declarations.values ?? [];
    if (samples.length !== 2 || samples[0].index !== 1 || samples[1].index !== 3) {
        fail(scene, "time samples", samples);
    }
    return samples.map(({value}) => value.referenceFile.src);
}

// Returns the files to which a scene refers.
export async function checkUsda(scene) {
    const {descriptor, statements} = parse(readFileSync(scene, "utf8"));
    const layer = Object.fromEntries(descriptor.assignments.map(({identifier, value}) => [identifier, value]));
    if (layer.startTimeCode !== 1 || layer.endTimeCode !== 3 || layer.timeCodesPerSecond !== 24) {
        fail(scene, "time codes", layer);
    }
    const prims = primsOf(statements);
    const root = `/${layer.defaultPrim}`;
    if (prims[`${root}/material/surface`]?.["info:id"] !== "UsdPreviewSurface" || !prims[`${root}/plane`]) {
        fail(scene, "prims", Object.keys(prims));
    }
    if (checkConnections(scene, prims) < 3) {
        fail(scene, "connections", prims);
    }
    const textures = Object.values(prims).filter((prim) => prim["info:id"] === "UsdUVTexture");
    return textures.flatMap((texture) => filesOf(scene, texture));
}
