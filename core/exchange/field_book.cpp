#include "core/exchange/field_book.h"

#include <utility>

#include "core/base/limits.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

constexpr const char* carriedAngles = PHRASE_LATER(
    "Phrase", "angles with 60 seconds or minutes, read as the next minute or degree: %1, first in line %2");

}  // namespace

void FieldBook::take(const FieldMark& mark) {
  switch (mark.kind) {
    case FieldMark::Kind::Axis:
      m_axis = mark.number;
      m_round.clear();
      break;
    case FieldMark::Kind::Round:
      m_round = mark.number;
      break;
    case FieldMark::Kind::Zero:
      m_zeroComes = true;
  }
}

bool FieldBook::add(RecordedSighting sighting) {
  sighting.axis.text = m_axis;
  sighting.row.round = m_round;
  sighting.station = m_station;
  const std::string& name = sighting.row.point;
  sighting.isZero = m_zeroComes || (m_zeroPoint.empty() ? isSameName(name, "0") || isSameName(name, "ZERO")
                                                        : isSameName(name, m_zeroPoint));
  m_zeroComes = false;
  m_isStationUsed = true;
  m_recording.sightings.push_back(std::move(sighting));
  return m_recording.sightings.back().isZero;
}

void FieldBook::enter(RecordedSighting& sighting, const RowField& circle, ExactAngle angle,
                      std::size_t column) {
  if (angle.isCarried) note(carriedAngles, sighting.line);
  sighting.enter(circle, std::move(angle.text), column);
}

void FieldBook::note(const char* sentence, std::size_t line) {
  Unused& use = m_notes[sentence];
  if (use.count++ == 0) use.firstLine = line;
}

void FieldBook::readLines(std::string_view text, const std::function<void(const TextLine&)>& readLine) {
  TextLines lines(text);
  while (const auto line = lines.next()) {
    readLine(*line);
    if (isFull(line->number)) break;
  }
  if (const auto line = lines.tailLine())
    setAside(Phrase::of("content after the end of the file (^Z)"), *line);
}

void FieldBook::refuse(std::size_t line, std::size_t column, const std::string& what) {
  m_recording.problems.push_back({line, column, what});
}

void FieldBook::setAside(const std::string& what, std::size_t line) {
  count(m_unused, what, line);
}

void FieldBook::setAsideSighting(const std::string& what, std::size_t line) {
  dropZeroMark();
  setAside(what, line);
}

void FieldBook::setAsideLine(std::string_view text, std::size_t line) {
  const bool isQuoted = ++m_quotedLines <= mostQuoted;
  setAside(
      isQuoted ? Phrase::of("the line %1", quotation(text)) : Phrase::of("a further line of unknown format"),
      line);
}

void FieldBook::setAsidePart(std::string_view text, std::size_t line) {
  const bool isQuoted = ++m_quotedParts <= mostQuoted;
  setAside(isQuoted ? Phrase::of("the text %1, no GSI word,", quotation(text))
                    : Phrase::of("a further text that is no GSI word"),
           line);
}

void FieldBook::beginStation(const std::string& name, std::size_t line) {
  setAsideForCheck(Phrase::of("the station %1", quotation(name)), line);
  m_station = m_recording.stationNamed(name);
  m_isStationUsed = false;
}

void FieldBook::count(Uses& uses, const std::string& what, std::size_t line) {
  const bool isNew = uses.size() >= limits::mostKinds && !uses.contains(what);
  Unused& use = uses[isNew ? Phrase::of("further content that a session cannot hold") : what];
  if (use.count++ == 0) use.firstLine = line;
}

void FieldBook::keep(std::string& value, const std::string& text, const std::string& name, std::size_t line) {
  if (value.empty() || value == text) {
    value = text;
  } else {
    setAside(name + " " + quotation(text), line);
  }
}

bool FieldBook::isFull(std::size_t line) {
  if (m_recording.problems.size() >= limits::mostProblems) return true;
  if (m_recording.sightings.size() <= limits::mostRows) return false;
  m_recording.problems = {{line, 0, limits::beyondTheRows()}};
  return true;
}

std::string FieldBook::sentence(const std::string& what, const Unused& unused) {
  return unused.count == 1
             ? Phrase::of("%1 is not used: line %2", what, unused.firstLine)
             : Phrase::of("%1 is not used: %2 times, first in line %3", what, unused.count, unused.firstLine);
}

Recording FieldBook::finish(const std::string& format) {
  m_recording.format = format;
  for (const auto& [what, use] : m_notes)
    m_recording.unused.push_back(Phrase::of(what, use.count, use.firstLine));
  for (const auto& [what, use] : m_unused) m_recording.unused.push_back(sentence(what, use));
  for (const auto& [what, use] : m_forCheck) m_recording.unusedBySession.push_back(sentence(what, use));
  return std::move(m_recording);
}

}  // namespace alidade
