#include "core/exchange/unread_rows.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

constexpr std::string_view meanWords =
    "mean means average avg sum total sums difference differences diff stddev stdev "
    "Mittel Mittelwert Mittelwerte Mittelbildung Summe Summen Durchschnitt Differenz Standardabweichung "
    "平均 平均值 均值 中数 合计 总计 和 差 互差 较差 标准差 "
    "promedio media medias suma diferencia moyenne moyennes moy somme différence "
    "среднее средние средний средняя сред ср сумма итого разность σ ∑ ø x̄ x̅ δ";

const std::set<std::string>& knownMeans() {
  static const std::set<std::string> known = [] {
    std::istringstream words{foldedText(meanWords)};
    std::set<std::string> all;
    for (std::string word; words >> word;) all.insert(word);
    all.erase("x");  // folded forms of x̄ and ø, which may be names of points
    all.erase("o");
    return all;
  }();
  return known;
}

/// Lists line numbers: `lines 3, 5, 7`.
std::string listed(const std::vector<std::size_t>& lines) {
  constexpr std::size_t most = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(lines.size(), most); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(lines[i]);
  if (lines.size() > most) text += ", …";
  return lines.size() == 1 ? Phrase::of("line %1", text) : Phrase::of("lines %1", text);
}

}  // namespace

bool namesMean(std::string_view cell) {
  if (cell.empty() || isDigit(cell.front())) return false;
  const std::string folded = foldedText(cell);
  const std::size_t end = std::min(folded.find_first_of(" .:;,()[]/-=0123456789"), folded.size());
  return end > 0 && knownMeans().contains(folded.substr(0, end));
}

bool hasAnyDigit(std::string_view cell) {
  if (std::ranges::any_of(cell, isDigit)) return true;
  const bool isAscii = std::ranges::all_of(cell, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  return !isAscii && (std::ranges::any_of(plainSigns(cell), isDigit) || hasForeignDigits(cell));
}

std::vector<std::string> UnreadRows::sentences() const {
  std::vector<std::string> sentences;
  const auto& [means, headings, empty] = m_lines;
  if (!means.empty())
    sentences.push_back(Phrase::of("rows of means or sums are not used: %1", listed(means)));
  if (!headings.empty())
    sentences.push_back(Phrase::of("rows that name the columns again are skipped: %1", listed(headings)));
  if (!empty.empty())
    sentences.push_back(Phrase::of("rows without a reading of a circle are not used: %1", listed(empty)));
  return sentences;
}

}  // namespace alidade
