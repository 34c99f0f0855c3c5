#include "ui/commands/hand_in.h"

#include <gmock/gmock.h>

#include "tests/ui/support.h"
#include "ui/document/session_document.h"

namespace alidade::ui {
namespace {

TEST(HandIn, EntersEveryKindOfTextAsItsEntryWould) {
  Session session = paperSession();
  session.instrument.known = {{.effect = "collimation", .value = "3", .sigma = "1", .unit = "arcsec"}};
  const Session entered = withHandedIn(
      session, {{.place = {.field = "notes"}, .text = "windy"},
                {.place = {.position = 1, .field = "pointing_zero.horizontal"}, .text = "332 32"},
                {.place = {.position = 0, .reading = 4, .field = "vertical"}, .text = "88 1"},
                {.place = {.position = 1, .reading = 17, .field = "horizontal"}, .text = "323 11 4"},
                {.place = {.field = "instrument.known[0].sigma"}, .text = "0.5"},
                {.place = {.field = "value"}, .effect = "trunnion_tilt", .parameter = "tilt", .text = "12"}});
  EXPECT_EQ(entered.notes, "windy");
  EXPECT_EQ(entered.positions[1].zero.horizontal, "332 32");
  EXPECT_EQ(entered.positions[0].readings[4].vertical, "88 1");
  ASSERT_EQ(entered.positions[1].readings.size(), 18u);
  EXPECT_EQ(entered.positions[1].readings[17].horizontal, "323 11 4");
  EXPECT_EQ(entered.positions[1].readings[17].point, "18");
  ASSERT_EQ(entered.instrument.known.size(), 2u);
  EXPECT_EQ(entered.instrument.known[0].sigma, "0.5");
  EXPECT_EQ(entered.instrument.known[1].effect, "trunnion_tilt");
  EXPECT_EQ(entered.instrument.known[1].value, "12");
}

/// Among others, a protocol by worth chose the place, which a recovered session cannot choose again.
TEST(HandIn, AddsTheRowThatWasTypedFor) {
  const Session entered =
      withHandedIn(paperSession(), {{.place = {.position = 1, .reading = 17, .field = "vertical"},
                                     .point = "5",
                                     .round = "3",
                                     .face = "2",
                                     .text = "88 1"}});
  const Reading& added = entered.positions[1].readings.at(17);
  EXPECT_EQ(added.vertical, "88 1");
  EXPECT_EQ(added.point + ' ' + added.round + ' ' + added.face, "5 3 2");
}

/// Another program may have removed the entry from the file while it was being typed.
TEST(HandIn, PassesOverWhatTheSessionDoesNotHave) {
  const Session session = paperSession();
  for (const HalfTypedText& typed : std::vector<HalfTypedText>{
           {.place = {.field = "no.such"}, .text = "1"},
           {.place = {.position = 7, .field = "pointing_zero.horizontal"}, .text = "1"},
           {.place = {.position = 7, .reading = 0, .field = "horizontal"}, .text = "1"},
           {.place = {.position = 0, .reading = 0, .field = "no such"}, .text = "1"},
           {.place = {.position = 0, .reading = 0, .field = "excluded"}, .text = "1"},
           {.place = {.field = "instrument.known[5].value"}, .text = "1"},
           {.place = {.reading = 0, .field = "journal"}, .text = "1"},
           {.place = {.field = "value"}, .effect = "no_such", .parameter = "tilt", .text = "1"},
           {.place = {.field = "no such"}, .effect = "trunnion_tilt", .parameter = "tilt", .text = "1"}})
    EXPECT_EQ(withHandedIn(session, {typed}), session) << typed.place.path();
}

/// The journal lists the old value, as for an entry committed by key.
TEST(HandIn, TellsTheJournalOfWhatStood) {
  SessionDocument document;
  document.startWithRecorded(paperSession());
  handIn(document, {{.place = {.position = 0, .reading = 4, .field = "vertical"}, .text = "88 1"}});
  ASSERT_EQ(document.session().journal.size(), 1u);
  EXPECT_EQ(document.session().journal[0].to, "88 1");
  document.undoStack().undo();
  EXPECT_EQ(document.session(), paperSession());
}

}  // namespace
}  // namespace alidade::ui
