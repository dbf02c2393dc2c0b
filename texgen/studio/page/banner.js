// SPDX-License-Identifier: Apache-2.0

import {$} from "./dom.js";

const kTexts = {
    offline: [
        "The program has ended or cannot be reached.",
        "Start it again with “foamtex studio”. This page tries again every 2 seconds and keeps your work.",
    ],
    forbidden: [
        "This page has no access to the program.",
        "Open the address that “foamtex studio” printed in the terminal. Its token can be used once.",
    ],
};

/** Shows or removes the banner about the connection: "online", "offline" or "forbidden". */
export function showConnection(state) {
    const text = kTexts[state];
    $("banner").hidden = !text;
    document.body.classList.toggle("disconnected", Boolean(text));
    if (text) {
        $("banner-title").textContent = text[0];
        $("banner-text").textContent = text[1];
    }
}
