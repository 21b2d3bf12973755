// A journal of practice on disk: nothing that the robot has gone through is lost by a crash.
//
// One JSON object a line: first what the run was told, then each task given and each skill executed, with the
// state after it. A line is handed to the operating system before the next skill is executed, and to the disk
// at the end of each cycle. A run is taken up by going through the journal again: the loop decides as it did,
// the answers come from the journal, and where it ends the world goes on. A torn last line (the crash came
// while it was written) is dropped. An open journal is locked (flock): no other journal, of whatever process,
// can be opened on the same file, so that two runs cannot mix.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "practice/environment.hpp"

namespace praxis::practice {

struct JournalTask {
    std::vector<GroundAtom> goal;
    State state;
    friend bool operator==(const JournalTask&, const JournalTask&) = default;
};
struct JournalStep {
    GroundSkill skill;
    std::vector<double> parameters;
    State state;  ///< afterwards
    friend bool operator==(const JournalStep&, const JournalStep&) = default;
};
using JournalRecord = std::variant<JournalTask, JournalStep>;

class Journal {
  public:
    /// Opens a journal, or begins one where there is no file (it stays empty until the first record).
    /// `settings` is a text of all that the run's course depends on. Throws InputError for a file that is no
    /// journal, has a damaged line, was made with other settings, or is open as a journal already;
    /// std::system_error if it cannot be read, written or locked.
    Journal(const std::string& path, const std::string& settings);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// What the file held when it was opened.
    const std::vector<JournalRecord>& records() const { return records_; }
    const std::string& path() const { return path_; }

    /// Throws std::system_error, and std::invalid_argument for numbers that are not finite.
    void append(const JournalRecord& record);
    /// To the disk. Throws std::system_error.
    void sync();

  private:
    void lock();
    void read(const std::string& settings);
    void write(const std::string& line);

    std::string path_;
    int file_ = -1;
    std::string header_;  // yet to be written
    std::vector<JournalRecord> records_;
};

/// A world whose past is in a journal: first it answers from there, then the world itself acts, and what it
/// does is written. Where the journal ends, the last state it tells of is answered until the next task or
/// skill, even if a real world has changed meanwhile: a skill is judged by what was seen after it.
class JournaledWorld : public World {
  public:
    /// Both must outlive this.
    JournaledWorld(World& world, Journal& journal) : world_(&world), journal_(&journal) {}

    /// These throw InputError where the journal tells of something else than is asked now: it was made by
    /// another program.
    std::vector<GroundAtom> next_task() override;
    void execute(const GroundSkill& skill, std::span<const double> parameters) override;
    const State& observe() override;

    /// Answers still come from the journal.
    bool replaying() const { return place_ < journal_->records().size(); }

  private:
    /// The next record of the journal, which must be of this kind.
    template <class Record>
    const Record& replay();
    void advance();

    World* world_;
    Journal* journal_;
    std::size_t place_ = 0;
    std::uint64_t skills_ = 0, tasks_ = 0;
    const State* past_ = nullptr;  // as the journal tells it; null since the world acts
};

}  // namespace praxis::practice
