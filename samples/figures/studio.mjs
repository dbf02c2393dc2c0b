// SPDX-License-Identifier: Apache-2.0
//
// Takes the picture of the studio: a loop of the preset lava in the dark theme. Run by make.sh.
//
//     FOAMTEX=PROGRAM node samples/figures/studio.mjs FOLDER PICTURE.png       # FOLDER is empty

import { launch_chromium, open_page } from "../../tests/browser/chromium.mjs";
import { start_studio } from "../../tests/studio/studio.mjs";

const [folder, picture] = process.argv.slice(2);
const studio = await start_studio(folder);
const browser = await launch_chromium();
const { page } = await open_page(browser);
await page.emulateMedia({ colorScheme: "dark" });
await page.setViewportSize({ width: 1440, height: 900 });
await page.goto(studio.url);
await page.waitForFunction(() => window.studio !== undefined);
await page.evaluate(() => window.studio.open("lava"));
await page.waitForFunction(
    () =>
        document.getElementById("loaded").textContent === "Loop in memory" &&
        document.querySelectorAll("#gallery-presets canvas.drawn").length >= 14,
    null,
    { timeout: 120_000 },
);
await page.evaluate(() => {
    window.studio.player.pause();
    window.studio.player.seek(4);
    document.getElementById("status-folder").textContent = "~/textures"; // the name of the scratch folder means nothing
});
await page.waitForTimeout(1500);
await page.screenshot({ path: picture });
await browser.close();
await studio.stop();
