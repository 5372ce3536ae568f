// All methods over all scenes in a few small tables, as text: for the page's head, the summary and a README.
#pragma once

#include <string>
#include <vector>

#include "editor/session/compare/result.h"

namespace relievo {

using TextTable = std::vector<std::vector<std::string>>;  // rows of as many cells; the first is the head

// A row a scene: the first method's time and errors, then its time over that of every other method at the
// coarsest setting that keeps p99.9 to 1e-3.
TextTable methods_table(const Comparison& comparison);
// A row a scene, a column a method at its least error: bytes built, milliseconds to build, and from an edit
// to the end of its upload.
TextTable built_table(const Comparison& comparison);
// A row a setting, a column a scene: time of a primary frame, its p99.9 depth error, missed and invented.
// What a sweep over one parameter looks like.
TextTable settings_table(const Comparison& comparison);

}  // namespace relievo
