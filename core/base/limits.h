#pragma once

#include <cstddef>
#include <string>

#include "core/base/problem.h"

namespace alidade::limits {

// How much the programs take in, wherever it comes from: a file, standard input or the window. Whatever is
// beyond gets one sentence before it can exhaust the memory. Reading anything takes less than 2 GB; a million
// rows are fitted and diagnosed within 2 GB.

/// Of a file or of standard input: the most rows at 256 bytes each, several times what a row takes.
inline constexpr std::size_t mostBytes = std::size_t{512} << 20;

/// Of a session or a file of readings, in all positions: a reading every second for three weeks.
inline constexpr std::size_t mostRows = 2'000'000;

/// Of a table: some ten are of use, and a line of some million cells is no line of a table.
inline constexpr std::size_t mostColumns = 1000;

/// Of a file of readings, each with its line and sentence: nobody mends more by hand, and no file with one is
/// imported.
inline constexpr std::size_t mostProblems = 100'000;

/// Of things in a GSI file that a session has no place for, each with its sentence.
inline constexpr std::size_t mostKinds = 1000;

/// Levels of lists and objects in a session file, which itself has 6: what reads them must not exhaust the
/// stack.
inline constexpr std::size_t deepestNesting = 100;

/// Of a session file besides its rows: each takes some hundred bytes of memory, many times its text.
inline constexpr std::size_t mostValues = 1'000'000;

/// Keys, values and brackets of a truth file: some twenty for each of ten thousand trials, and room.
inline constexpr std::size_t mostTruthEvents = 2'000'000;

/// Of one text in bytes: notes of many hundred pages. Every text is kept several times over.
inline constexpr std::size_t longestText = std::size_t{1} << 20;

std::string asMebibytes(std::size_t bytes);  ///< `512 MiB`
std::string asCount(std::size_t count);      ///< `2,000,000`

Problem tooManyBytes();
Problem tooManyRows();
/// Of a line of a file of readings.
std::string beyondTheRows();

}  // namespace alidade::limits
