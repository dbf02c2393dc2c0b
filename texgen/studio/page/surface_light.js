// SPDX-License-Identifier: Apache-2.0

// The direction to the light of the lit preview, {azimuth, elevation} in degrees (Surface.setLight).

const kDegree = Math.PI / 180;
const kLowest = 2;  // smallest elevation of a light that is moved, in degrees

// Returns the direction as a vector of length 1.
export function directionTo({azimuth, elevation}) {
    const across = Math.cos(elevation * kDegree);
    return [
        across * Math.cos(azimuth * kDegree),
        across * Math.sin(azimuth * kDegree),
        Math.sin(elevation * kDegree),
    ];
}

// Returns the direction after a move by x to the right and y up. The light is a point on a half sphere of radius 1,
// which is seen from the front.
export function movedLight(light, x, y) {
    const [oldX, oldY] = directionTo({...light, elevation: Math.max(light.elevation, 0)});
    const newX = oldX + x;
    const newY = oldY + y;
    const radius = Math.min(Math.hypot(newX, newY), Math.cos(kLowest * kDegree));
    return {
        azimuth: (Math.atan2(newY, newX) / kDegree + 360) % 360,
        elevation: Math.max(Math.acos(radius) / kDegree, kLowest),
    };
}
