#pragma once

#include <QString>
#include <cstdint>
#include <map>

namespace alidade::ui {

/// With this option the test program types in a window, into a session, until it is killed.
inline constexpr const char* typistOption = "--type-until-killed";

/// Keeps unsaved changes in `folder` and works on the session in `path`, if not empty. Numbers its edits in
/// the session's title, continuing the number found; saves after every hundredth. `log` gets a line per
/// committed edit: its number and time.
int typeUntilKilled(const char* folder, const char* path, const char* log);

/// The commit time of each edit in a log, in ns of the steady clock, which processes share.
std::map<int, std::int64_t> committedEdits(const QString& log);

std::int64_t steadyNanoseconds();

}  // namespace alidade::ui
