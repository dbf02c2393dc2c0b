// SPDX-License-Identifier: Apache-2.0

// Checks documents of MaterialX with MaterialX itself, which is compiled to WebAssembly.

import {readFileSync} from "node:fs";
import {createRequire} from "node:module";
import {join} from "node:path";
import {PACKAGES} from "./packages.mjs";

const folder = `${PACKAGES}/@needle-tools/materialx/bin`;

// The package is made for browsers and for modules of CommonJS.
globalThis.require = createRequire(import.meta.url);
globalThis.__dirname = folder;
globalThis.__filename = join(folder, "JsMaterialXGenShader.js");
const {default: load} = await import(globalThis.__filename);
const MaterialX = await load({locateFile: (name) => join(folder, name.endsWith(".data") ? `${name}.txt` : name)});
const generator = MaterialX.EsslShaderGenerator.create();
const context = new MaterialX.GenContext(generator);
const library = MaterialX.loadStandardLibraries(context);

async function read(text) {
    const document = MaterialX.createDocument();
    document.setDataLibrary(library);
    await MaterialX.readFromXmlString(document, text, "");
    return document;
}

// Throws unless the document is valid and a shader can be made of it. Returns the files to which it refers.
export async function checkMtlx(scene) {
    const text = readFileSync(scene, "utf8");
    const document = await read(text);
    if (!document.validate()) {
        throw new Error(`${scene}: the document is invalid`);
    }
    const shader = generator.generate("shader", MaterialX.findRenderableElement(document), context);
    if (!shader.getSourceCode("pixel").includes("void main()")) {
        throw new Error(`${scene}: no shader`);
    }
    // The check can fail: a node that does not exist makes the document invalid.
    if ((await read(text.replace('nodename="image_', 'nodename="missing_'))).validate()) {
        throw new Error(`${scene}: a broken document is valid`);
    }
    const graph = document.getNodeGraph("images");
    return graph.getNodes().filter((node) => ["image", "tiledimage"].includes(node.getCategory()))
        .map((node) => node.getInput("file").getValueString());
}
