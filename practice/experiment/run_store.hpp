// The finished runs of an experiment: one file a run in one directory, so that an experiment that was stopped
// goes on where it was.
//
//     RunStore store("results", "tasks=100 cycles=10 ...");
//     if (!store.contains(key)) store.save(run(key));
//
// A run is in `ENVIRONMENT.METHOD.SEED.json`; characters of the names other than letters, digits, "-" and "_"
// are written as "%" and two hexadecimal digits. A file appears whole or not at all, and several processes
// may write to one directory. Every file holds the fingerprint of the settings it was made with: runs with
// other settings do not mix.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "practice/experiment/results.hpp"

namespace praxis::practice {

/// What is run: one file.
struct RunKey {
    std::string environment, method;
    std::uint64_t seed = 0;
    auto operator<=>(const RunKey&) const = default;
};

class RunStore {
  public:
    /// Makes the directory if there is none. `fingerprint`: all settings that change results, as readable
    /// text. Throws OutputError where the directory cannot be made.
    RunStore(std::string directory, std::string fingerprint);

    /// Whether the run is finished. Its file is not read.
    bool contains(const RunKey& key) const;
    /// The finished runs, sorted; files with other names are passed over. Throws InputError where the
    /// directory cannot be read.
    std::vector<RunKey> finished() const;
    /// Throws InputError, saying what to do, where the file is missing, damaged, of another run or made with
    /// other settings.
    RunResult load(const RunKey& key) const;
    /// All finished runs, in the order of `finished`.
    std::vector<RunResult> load_all() const;
    /// Replaces an earlier result. Throws OutputError; std::invalid_argument as `run_to_json` does.
    void save(const RunResult& run) const;

    /// The file of a run.
    std::string path(const RunKey& key) const;

  private:
    std::string directory_;
    std::string fingerprint_;
};

}  // namespace praxis::practice
