#pragma once

#include <QString>
#include <cstdint>
#include <map>

namespace alidade::ui {

/// The option by which the test program types instead of testing: in a window, into a session, until it is
/// killed.
inline constexpr const char* typistOption = "--type-until-killed";

/// Keeps unsaved changes in `folder`, works on the session in `path` where that is not empty, and numbers its
/// edits in the session's title, on from the number that is there. Every hundredth is followed by a save. A
/// line of `log` for each committed edit: its number and when that was.
int typeUntilKilled(const char* folder, const char* path, const char* log);

/// When each edit of a log was committed, in ns of the steady clock, which processes share.
std::map<int, std::int64_t> committedEdits(const QString& log);

std::int64_t steadyNanoseconds();

}  // namespace alidade::ui
