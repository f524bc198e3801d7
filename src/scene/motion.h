// SPDX-License-Identifier: Apache-2.0
//
// Motion between keys: maps are taken apart into translation, rotation and stretch (polar decomposition; Shoemake and
// Duff 1992, "Matrix animation and polar decomposition"), which change evenly, rotations by the shorter way.
#pragma once

#include "scene/scene.h"

namespace snell::scene {

// The place at a moment. `motion` has a key at least.
Affine PlaceAt(const Motion& motion, double time);

// Where an object is at a moment.
Affine ToWorldAt(const Object& object, double time);

// A camera's frame: x to the right, y up, z backwards, at its position; and as it is at a moment.
Affine FrameOf(const Camera& camera);
Affine FrameAt(const Camera& camera, double time);

// What moves within something that moves, by outer · inner, with the keys of both.
Motion Compose(const Affine& outerPlace, const Motion& outer, const Affine& innerPlace,
               const Motion& inner);

// Whether anything changes from `open` to `close`.
bool IsMoving(const Motion& motion, double open, double close);

// Into how many even steps the time from `open` to `close` is to be cut, so that straight ways from one to the next keep
// close to the motion: turns of 2 degrees at most, and all keys on the cuts if 256 suffice.
int StepsOf(const Motion& motion, double open, double close);

// The fewest even steps, from `least` on, between which all `cuts` lie, which are shares of the time; `most` if fewer do
// not do.
int EvenSteps(const std::vector<double>& cuts, int least, int most);

// Whether the map turns things inside out on its way, which no key may do against another.
bool KeepsHandedness(const Motion& motion);

}  // namespace snell::scene
