#pragma once

#include <cstddef>
#include <string>

#include "core/base/problem.h"

namespace alidade::limits {

// Limits of input from any source: a file, standard input or the window. Anything beyond is refused with one
// sentence before it exhausts the memory. Reading takes less than 2 GB of memory; the fit and the diagnosis
// of a million rows take less than 2 GB, too.

/// Largest file or standard input in bytes: room for `mostRows` rows of several times the usual length.
inline constexpr std::size_t mostBytes = std::size_t{512} << 20;

/// Most rows of a session or a file of readings, in all positions: a reading every second for three weeks.
inline constexpr std::size_t mostRows = 2'000'000;

/// Most columns of a table: some ten are used, and a line with a million cells cannot belong to a table.
inline constexpr std::size_t mostColumns = 1000;

/// Most problems of a file of readings, each with its line and sentence: more cannot be corrected by hand,
/// and a file with any problem is not imported.
inline constexpr std::size_t mostProblems = 100'000;

/// Most kinds of unused data reported for a GSI file, each in a sentence.
inline constexpr std::size_t mostKinds = 1000;

/// Deepest nesting of lists and objects in a session file; 6 is usual. Reading must not exhaust the stack.
inline constexpr std::size_t deepestNesting = 100;

/// Most values of a session file outside its rows. Each takes about a hundred bytes of memory, many times its
/// text.
inline constexpr std::size_t mostValues = 1'000'000;

/// Most keys, values and brackets of a truth file: ten times as many as ten thousand trials need.
inline constexpr std::size_t mostTruthEvents = 2'000'000;

/// Longest single text in bytes: notes of many hundred pages. Several copies of each text are in memory.
inline constexpr std::size_t longestText = std::size_t{1} << 20;

std::string asMebibytes(std::size_t bytes);  ///< `512 MiB`
std::string asCount(std::size_t count);      ///< `2,000,000`

Problem tooManyBytes();
Problem tooManyRows();
/// The problem of a line beyond `mostRows` in a file of readings.
std::string beyondTheRows();

}  // namespace alidade::limits
