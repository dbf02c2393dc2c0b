// SPDX-License-Identifier: Apache-2.0

// Turns the JSON Schema of preset files into lists of keys that the form and the editor of events can show.

const kColor = "^#[0-9a-fA-F]{6}$";
const kColorStart = "^#[0-9a-fA-F]{6}"; // also the start of the pattern of a color with a position

/**
 * Returns the tables of the schema, in the order of the schema: {name, keys}. A key has `path`,
 * `table`, `name`, `kind`, `help`, `unit`, `default` and `condition` (see conditions.js). Depending
 * on its kind, it also has `choices`, `min`, `max`, `integer`, `word` (a special value that is
 * allowed instead of a number of the range, such as "auto" or 0) and `length`. Kinds are number,
 * choice, color, colors, choices, numbers, texts and text.
 */
export function tablesOf(schema) {
    return Object.entries(schema.properties)
        .filter(([, table]) => table.properties)
        .map(([name, table]) => ({name, keys: keysOf(name, table.properties)}));
}

/** Returns the kinds of events: {name, help, keys}. */
export function eventKindsOf(schema) {
    return schema.properties.event.items.anyOf.map((kind) => ({
        name: kind.properties.kind.enum[0],
        help: kind.description,
        keys: keysOf("event", kind.properties).filter((key) => key.name !== "kind"),
    }));
}

function keysOf(table, properties) {
    return Object.entries(properties).map(([name, schema]) => keyOf(table, name, schema));
}

function keyOf(table, name, schema) {
    return {
        path: `${table}.${name}`,
        table,
        name,
        help: schema.description ?? "",
        unit: schema["x-unit"] ?? "",
        default: schema.default,
        condition: conditionOf(schema),
        ...kindOf(schema),
    };
}

function conditionOf(schema) {
    for (const rule of ["only-for", "used-with", "unused-with"]) {
        const found = schema[`x-${rule}`];
        if (found) {
            return {rule, key: found.key, values: found.values};
        }
    }
    return null;
}

function numberKind(schema) {
    return {kind: "number", integer: schema.type === "integer", min: schema.minimum, max: schema.maximum};
}

function listKind(schema) {
    const item = schema.items;
    if (item.enum) {
        return {kind: "choices", choices: item.enum};
    }
    if (item.pattern?.startsWith(kColorStart)) {
        return {kind: "colors"};
    }
    if (item.type === "string") {
        return {kind: "texts"};
    }
    const length = schema.minItems === schema.maxItems ? schema.minItems : null;
    return {...numberKind(item), kind: "numbers", length};
}

function kindOf(schema) {
    if (schema.anyOf) {
        return kindOfAlternatives(schema.anyOf);
    }
    if (schema.enum) {
        return {kind: "choice", choices: schema.enum};
    }
    if (schema.type === "array") {
        return listKind(schema);
    }
    if (schema.type === "number" || schema.type === "integer") {
        return numberKind(schema);
    }
    return schema.pattern === kColor ? {kind: "color"} : {kind: "text"};
}

// A key with alternatives takes either a number or one special value, such as "auto" or 0; or it
// takes one item or a list of items, which may also be empty.
function kindOfAlternatives(nested) {
    const alternatives = nested.flatMap((one) => one.anyOf ?? [one]);
    const word = alternatives.find((one) => "const" in one);
    const list = alternatives.find((one) => one.type === "array" && one.items);
    if (list) {
        return listKind(list);
    }
    const number = alternatives.find((one) => one.type === "number" || one.type === "integer");
    return {...numberKind(number), word: word.const};
}
