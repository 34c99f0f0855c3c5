#include <gmock/gmock.h>

#include <QTemporaryDir>
#include <iterator>
#include <numeric>
#include <random>
#include <vector>

#include "core/session/journal_check.h"
#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/commands/change_positions.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/commands/session_commands.h"
#include "ui/document/session_document.h"

// After any sequence of edits, undo, save and seal, the journal of the file is consistent.

namespace alidade::ui {
namespace {

class Player {
 public:
  explicit Player(unsigned seed) : m_random(seed) {
    m_document.startWith(paperSession());
    save();
  }

  void step() {
    const std::size_t position = any(m_document.session().positions.size());
    ReadingsEditor editor(m_document, position);
    const std::size_t rows = m_document.session().positions[position].readings.size();
    switch (any(16)) {
      case 0:
      case 1:
      case 2:
        editor.setCell({any(rows + 1), anyColumn()}, anyText());
        break;
      case 3:
        changeField(m_document, {.field = anyField()}, anyText());
        break;
      case 4:
        changeField(m_document, {.position = position, .field = "pointing_zero.vertical"}, anyText());
        break;
      case 5:
        editor.setExcluded({any(rows / 2 + 1), rows / 2 + 1 + any(rows / 2)}, any(2) == 0);
        break;
      case 6:
        editor.insertBlank(any(rows + 1));
        break;
      case 7:
        if (rows > 8) editor.remove({any(rows), any(rows), any(rows)});
        break;
      case 8:
        editor.clear({{any(rows / 2 + 1), anyColumn()}, {rows / 2 + 1 + any(rows / 2), anyColumn()}});
        break;
      case 9:
        editor.paste({{QStringLiteral("1 00 00"), QStringLiteral("2 00 00")}, {QStringLiteral("3 00 00")}},
                     any(rows + 1), {ReadingColumn::Horizontal, ReadingColumn::Vertical});
        break;
      case 10:
        if (rows > 8)
          moveRows(m_document, position, {any(rows), any(rows)}, 1 - std::min<std::size_t>(position, 1));
        break;
      case 11:
        typeKnown(m_document, knownRows(m_document.session()).at(any(5)), knownCells[any(3)], anyText());
        break;
      case 12:
        save();
        break;
      case 13:
        m_document.undoStack().undo();
        break;
      case 14:
        m_document.undoStack().redo();
        break;
      default:
        if (any(6) == 0) m_document.push(new SealSession(m_document, "R. Roe"));
    }
  }

  JournalCheck checked() const { return checkJournal(*readSession(writeSession(m_document.session()))); }
  /// Opens the session as the next window does.
  void reopen() { m_document.startWithRecorded(*readSession(writeSession(m_document.session()))); }
  const Session& session() const { return m_document.session(); }

 private:
  std::size_t any(std::size_t count) {
    return count == 0 ? 0 : std::uniform_int_distribution<std::size_t>(0, count - 1)(m_random);
  }
  ReadingColumn anyColumn() {
    constexpr ReadingColumn columns[] = {
        ReadingColumn::Point, ReadingColumn::Horizontal, ReadingColumn::Vertical, ReadingColumn::Slider,
        ReadingColumn::Round, ReadingColumn::Note,       ReadingColumn::Vertical, ReadingColumn::Face};
    return columns[any(std::size(columns))];
  }
  std::string anyField() {
    constexpr const char* fields[] = {"title",
                                      "notes",
                                      "geometry.distance_mm",
                                      "acceptance.tolerance_mm",
                                      "instrument.serial",
                                      "environment.temperature_c",
                                      "geometry.vertical_circle"};
    return fields[any(std::size(fields))];
  }
  std::string anyText() {
    const char* const texts[] = {"", "1", "2", "88 00 00", "a, point 3", "1.0", "true", "\"", "341°52'24\""};
    return texts[any(std::size(texts))];
  }
  void save() { EXPECT_FALSE(m_document.save(m_folder.filePath(QStringLiteral("s.alidade")))); }

  std::mt19937 m_random;
  QTemporaryDir m_folder;
  SessionDocument m_document;
};

// Seeds of sessions that once failed although they were unaltered. They contain two deletions within one
// second, empty rows without an entry before the first seal, or rows with the same point, round and face in
// both positions.
constexpr unsigned hardSeeds[] = {82,  84,  102, 137, 185, 187, 198, 205, 225, 267, 271, 308,
                                  324, 417, 425, 562, 577, 586, 625, 629, 632, 635, 638};

std::vector<unsigned> playedSeeds() {
  std::vector<unsigned> seeds(60);
  std::iota(seeds.begin(), seeds.end(), 1U);
  seeds.insert(seeds.end(), std::begin(hardSeeds), std::end(hardSeeds));
  return seeds;
}

TEST(JournalOfPlay, HoldsAfterAnyEdits) {
  for (const unsigned seed : playedSeeds()) {
    Player player(seed);
    for (int i = 1; i <= 120; ++i) {
      player.step();
      if (i % 40 == 0) player.reopen();
      if (i % (seed > 60 ? 3 : 10) != 0) continue;
      const JournalCheck check = player.checked();
      if (check.holds()) continue;
      for (const JournalContradiction& one : check.contradictions)
        ADD_FAILURE() << "seed " << seed << ", step " << i << ": " << one.place << ": told " << one.recorded
                      << ", held " << one.held;
      for (const CheckedSeal& seal : check.seals)
        EXPECT_NE(seal.state, CheckedSeal::State::Changed) << "seed " << seed << ", step " << i;
      if (check.contradictions.empty())
        for (const JournalEntry& entry : player.session().journal)
          std::printf("%s | %s > %s | %s\n", entry.place.c_str(), entry.from.c_str(), entry.to.c_str(),
                      entry.why.c_str());
      break;
    }
  }
}

}  // namespace
}  // namespace alidade::ui
