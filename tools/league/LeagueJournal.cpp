// SPDX-License-Identifier: Apache-2.0
#include "tools/league/LeagueJournal.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "tools/league/JournalLines.h"

namespace kelpie::league {
namespace {

// A journal as it is on the disk.
struct JournalText {
  bool begun = false;  // the header is whole
  LeagueRecord record;
  std::vector<ScheduledMatch> schedule;
  std::size_t wholeBytes = 0;  // up to the end of the last whole line
};

// Empty where there is no file yet; one that cannot be read must not be taken for that.
Expected<std::string> readAll(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return std::string();
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  const bool readable = std::filesystem::is_regular_file(path, error) && in.good();
  if (readable && in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
  if (!readable || in.bad() || !text.good()) return Error{path + ": cannot be read"};
  return text.str();
}

// Whether a text without a line's end is what is left of a header, so that nothing is lost with it.
bool isPartOfHeader(const std::string& text) {
  const std::string start = kHeaderStart;
  const std::size_t common = std::min(start.size(), text.size());
  return text.compare(0, common, start, 0, common) == 0;
}

Status readHeader(const std::string& path, const std::string& text, JournalText& journal) {
  const auto end = text.find('\n');
  if (end == std::string::npos)
    return isPartOfHeader(text) ? Status(Done{}) : Error{path + ": not the journal of a league"};
  auto plan = planOfHeader(text.substr(0, end));
  if (!plan) return Error{path + ": " + plan.error()};
  journal.begun = true;
  journal.record.plan = std::move(*plan);
  journal.schedule = scheduleOf(journal.record.plan);
  journal.record.results.resize(journal.schedule.size());
  journal.wholeBytes = end + 1;
  return Done{};
}

Expected<JournalText> readJournal(const std::string& path) {
  const auto whole = readAll(path);
  if (!whole) return Error{whole.error()};
  const std::string& text = *whole;
  JournalText journal;
  const Status header = readHeader(path, text, journal);
  if (!header) return Error{header.error()};
  if (!journal.begun) return journal;
  int line = 1;
  for (auto end = text.find('\n', journal.wholeBytes); end != std::string::npos;
       end = text.find('\n', journal.wholeBytes)) {
    const auto begin = std::exchange(journal.wholeBytes, end + 1);
    ++line;
    if (!readMatchLine(text.substr(begin, end - begin), journal.schedule, journal.record.results))
      return Error{fmt::format("{}:{}: damaged: not a match of this league", path, line)};
  }
  return journal;
}

Error systemError(const std::string& path) { return Error{path + ": " + std::strerror(errno)}; }

std::string lockPath(const std::string& folder) { return folder + "/league.lock"; }

// The locked file's descriptor. Closed in children, so that none of them keeps the lock.
Expected<int> lockFolder(const std::string& folder) {
  const int lock = ::open(lockPath(folder).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock < 0) return systemError(lockPath(folder));
  if (flock(lock, LOCK_EX | LOCK_NB) == 0) return lock;
  const bool taken = errno == EWOULDBLOCK;
  const Error error = systemError(lockPath(folder));
  ::close(lock);
  return taken ? Error{folder + ": another process plays this league"} : error;
}

Status checkSame(const std::string& path, const JournalText& journal, const LeaguePlan& plan) {
  if (!journal.begun) return Done{};
  const std::string difference = differenceOf(journal.record.plan, plan);
  if (difference.empty()) return Done{};
  return Error{path + ": the journal of another league (" + difference + ")"};
}

// False: errno says why; the file may have grown by a part of the text.
bool writeWhole(int file, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t wrote = ::write(file, text.data() + done, text.size() - done);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) return false;
    done += static_cast<std::size_t>(wrote);
  }
  return true;
}

}  // namespace

std::string journalPath(const std::string& folder) { return folder + "/league.jsonl"; }

Expected<LeagueRecord> readLeague(const std::string& folder) {
  const std::string path = journalPath(folder);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return Error{path + ": no such file"};
  auto journal = readJournal(path);
  if (!journal) return Error{journal.error()};
  if (!journal->begun) return Error{path + ": no league has begun here"};
  return std::move(journal->record);
}

LeagueJournal::LeagueJournal(std::string path, LeagueRecord record)
    : path_(std::move(path)), record_(std::move(record)), schedule_(scheduleOf(record_.plan)) {
  record_.results.resize(schedule_.size());
}

LeagueJournal::LeagueJournal(LeagueJournal&& other) noexcept
    : path_(std::move(other.path_)),
      record_(std::move(other.record_)),
      schedule_(std::move(other.schedule_)),
      lock_(std::exchange(other.lock_, -1)),
      file_(std::exchange(other.file_, -1)) {}

LeagueJournal::~LeagueJournal() {
  if (file_ >= 0) ::close(file_);
  if (lock_ >= 0) ::close(lock_);
}

Expected<LeagueJournal> LeagueJournal::open(const std::string& folder, const LeaguePlan& plan) {
  const Status playable = checkPlan(plan);
  if (!playable) return Error{playable.error()};
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return Error{folder + ": " + error.message()};
  const auto lock = lockFolder(folder);
  if (!lock) return Error{lock.error()};
  LeagueJournal journal(journalPath(folder), {plan, {}});
  journal.lock_ = *lock;
  auto before = readJournal(journal.path_);
  if (!before) return Error{before.error()};
  const Status same = checkSame(journal.path_, *before, plan);
  if (!same) return Error{same.error()};
  journal.file_ = ::open(journal.path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (journal.file_ < 0 || ::ftruncate(journal.file_, static_cast<off_t>(before->wholeBytes)) != 0)
    return systemError(journal.path_);
  if (before->begun) journal.record_.results = std::move(before->record.results);
  const Status begun = before->begun ? Status(Done{}) : journal.append(headerLine(plan));
  if (!begun) return Error{begun.error()};
  return journal;
}

Status LeagueJournal::append(const std::string& line) {
  struct stat before = {};
  if (::fstat(file_, &before) != 0) return systemError(path_);
  if (writeWhole(file_, line + "\n")) return Done{};
  const Error error = systemError(path_);
  // A part of a line would spoil the next one; where even this fails, add() is not called again.
  if (::ftruncate(file_, before.st_size) != 0) return systemError(path_);
  return error;
}

Status LeagueJournal::add(std::size_t match, const MatchResult& result) {
  const Status kept = append(matchLine(match, schedule_[match].match, result));
  if (kept) record_.results[match] = result;
  return kept;
}

void LeagueJournal::forgetVoids() {
  for (auto& result : record_.results)
    if (result && !result->trouble.empty()) result.reset();
}

}  // namespace kelpie::league
