#include "core/exchange/table_faces.h"

#include <algorithm>

#include "core/exchange/heading_words.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

/// The one word of a cell that states the face: `Lage I`, `cara 1`, `F1`. Empty if there are several.
std::string faceWordOf(const std::string& cell) {
  std::string found;
  for (const std::string& word : headingWords(cell)) {
    const bool saysNothing = means(HeadingRole::Filler, word) || means(HeadingRole::CircleWord, word) ||
                             means(HeadingRole::Axis, word) ||
                             (means(HeadingRole::Face, word) && word != "kl");
    if (saysNothing) continue;
    if (!found.empty()) return {};
    found = word;
  }
  return found;
}

bool maySaySeveral(std::string_view word) {
  return isOneOf(word, {"d", "i", "g", "r", "cd", "ci", "cg"});
}

}  // namespace

FaceWords::FaceWords(const std::vector<std::string>& cells, bool isSpanish) : m_isSpanish(isSpanish) {
  for (const std::string& cell : cells) {
    std::string word = faceWordOf(cell);
    if (maySaySeveral(word) && !has(word)) m_letters.push_back(std::move(word));
  }
}

bool FaceWords::has(std::string_view word) const {
  return std::ranges::find(m_letters, word) != m_letters.end();
}

std::string FaceWords::of(const std::string& cell) const {
  if (cell == "1" || cell == "2" || cell.empty()) return cell;
  const std::string word = faceWordOf(cell);
  const bool isDirecto = m_isSpanish && has("d") && has("i");
  if (word == "d" && (isDirecto || (has("r") && !has("i")))) return "1";
  if (word == "d") return has("g") ? "2" : cell;
  if (word == "g") return has("d") ? "1" : cell;
  if (word == "i" && isDirecto) return "2";
  if (word == "cd") return has("ci") ? "1" : has("cg") ? "2" : cell;
  if (word == "ci") return has("cd") || m_isSpanish ? "2" : cell;
  if (isOneOf(word, {"vl", "kl"}) || means(HeadingRole::FaceOne, word)) return "1";
  if (isOneOf(word, {"vr", "kr"}) || means(HeadingRole::FaceTwo, word)) return "2";
  return cell;
}

}  // namespace alidade
