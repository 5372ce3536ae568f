// The stability suite as a report (`compare --stability`): every registered method on every extreme case of
// DESIGN.md section 8, and the matrix as a page, CSV and JSON.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "renderer/stability/harness.h"

namespace relievo {

struct StabilityRow {
    std::string group, name, what;        // of the case
    std::vector<std::string> complaints;  // about the case itself; none, unless the suite is broken
    std::vector<stability::Cell> cells;   // one a method
};

struct StabilityMatrix {
    std::vector<std::string> methods;
    std::vector<StabilityRow> rows;
    std::string device, driver, version;
    double spent_s = 0;

    int count(std::size_t method, stability::Verdict verdict) const;
    bool kept() const;  // no method breaks a promise
};

struct StabilityOptions {
    std::vector<std::string> methods;  // empty: all of the registry
    std::vector<std::string> cases;    // empty: all
    int size = stability::kCaseSize;   // pixels a side of the images
    std::string device;
    TracePath path = TracePath::automatic;
};

// "dunes,cliffs" to names of cases. Throws std::invalid_argument naming --cases.
std::vector<std::string> parse_cases(const std::string& list);

// Throws std::invalid_argument on an unknown method or case, std::runtime_error without a device. A method's
// own failures are cells.
StabilityMatrix run_stability(
    const StabilityOptions& options,
    const std::function<void(int done, int total, const std::string& name)>& progress = {});

std::string html_text(const StabilityMatrix& matrix);     // one page, needs nothing else
std::string csv_text(const StabilityMatrix& matrix);      // a line a case and method
std::string json_text(const StabilityMatrix& matrix);     // with every view
std::string summary_text(const StabilityMatrix& matrix);  // the matrix, then what is not as promised

// Makes the folder and sees that it can be written, before the work. Throws std::invalid_argument.
void prepare_stability_folder(const std::filesystem::path& folder);
// index.html, stability.csv and stability.json. Throws std::invalid_argument when they cannot be written.
void write_stability(const StabilityMatrix& matrix, const std::filesystem::path& folder);

}  // namespace relievo
