// SPDX-License-Identifier: Apache-2.0

import {$, setIcon, setLabel} from "./dom.js";

const kStore = "foamtex-studio-theme"; // key in localStorage
const dark = matchMedia("(prefers-color-scheme: dark)");

const current = () => localStorage.getItem(kStore) ?? (dark.matches ? "dark" : "light");

function show() {
    const theme = current();
    const button = $("theme");
    document.documentElement.dataset.theme = theme;
    setIcon(button, theme === "dark" ? "sun" : "moon");
    setLabel(button, theme === "dark" ? "Light theme (T)" : "Dark theme (T)");
}

/** Switches between the light and the dark theme, and keeps the choice. */
export function toggleTheme() {
    localStorage.setItem(kStore, current() === "dark" ? "light" : "dark");
    show();
}

/** Shows the theme that was chosen before, or else the theme of the system. */
export function startTheme() {
    show();
    dark.addEventListener("change", show);
    $("theme").addEventListener("click", toggleTheme);
}
