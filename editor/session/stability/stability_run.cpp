// Runs the suite, and writes its files.
#include <chrono>
#include <span>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "brushes/atomic_file.h"
#include "editor/session/image_file.h"
#include "editor/session/stability/stability_report.h"

namespace relievo {
namespace {

using stability::CaseEntry;
using stability::Verdict;

std::vector<CaseEntry> chosen_cases(const std::vector<std::string>& names) {
    if (names.empty()) return stability::cases();
    std::vector<CaseEntry> chosen;
    for (const std::string& name : names) chosen.push_back(stability::find_case(name));
    return chosen;
}

std::vector<const Method*> chosen_methods(const std::vector<std::string>& names) {
    if (names.empty()) return {methods().begin(), methods().end()};
    std::vector<const Method*> chosen;
    for (const std::string& name : names) chosen.push_back(&find_method(name));
    return chosen;
}

void write(const std::filesystem::path& path, const std::string& text) {
    write_file_atomically(path, std::as_bytes(std::span(text)));
}

}  // namespace

int StabilityMatrix::count(std::size_t method, Verdict verdict) const {
    int found = 0;
    for (const StabilityRow& row : rows) found += row.cells[method].verdict == verdict ? 1 : 0;
    return found;
}

bool StabilityMatrix::kept() const {
    for (const StabilityRow& row : rows)
        for (const stability::Cell& cell : row.cells)
            if (!cell.kept()) return false;
    return true;
}

std::vector<std::string> parse_cases(const std::string& list) {
    std::vector<std::string> names;
    std::istringstream words(list);
    for (std::string word; std::getline(words, word, ',');) {
        try {
            names.push_back(stability::find_case(word).name);
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument("--cases: " + std::string(error.what()));
        }
    }
    return names;
}

StabilityMatrix run_stability(const StabilityOptions& options,
                              const std::function<void(int, int, const std::string&)>& progress) {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<const Method*> judged = chosen_methods(options.methods);
    const std::vector<CaseEntry> entries = chosen_cases(options.cases);
    vulkan::Context context({options.device, false, false});
    StabilityMatrix matrix;
    matrix.device = context.info().name;
    matrix.driver = context.info().driver;
    matrix.version = RELIEVO_VERSION;
    for (const Method* method : judged) matrix.methods.emplace_back(method->name);
    for (const CaseEntry& entry : entries) {
        if (progress)
            progress(static_cast<int>(matrix.rows.size()), static_cast<int>(entries.size()), entry.name);
        const stability::JudgedCase judge(entry, options.size);
        StabilityRow row{entry.group, entry.name, entry.what, judge.complaints(), {}};
        for (const Method* method : judged) row.cells.push_back(judge.run(context, *method, options.path));
        matrix.rows.push_back(std::move(row));
    }
    matrix.spent_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return matrix;
}

void prepare_stability_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || !std::filesystem::is_directory(folder))
        throw std::invalid_argument(folder.string() + ": cannot make the folder: " +
                                    (error ? error.message() : "there is a file of that name"));
    check_writable(folder / "index.html");
}

void write_stability(const StabilityMatrix& matrix, const std::filesystem::path& folder) {
    write(folder / "stability.csv", csv_text(matrix));
    write(folder / "stability.json", json_text(matrix));
    write(folder / "index.html", html_text(matrix));
}

}  // namespace relievo
