#include "ui/recovery/recovery_record.h"

#include <gmock/gmock.h>

#include "tests/ui/support.h"

namespace alidade::ui {
namespace {

TEST(RecoveryRecord, IsReadAsItWasWritten) {
  const QDateTime now = QDateTime::fromString(QStringLiteral("2026-11-22T03:04:05.678"), Qt::ISODateWithMs);
  Session session = paperSession();
  session.notes = "two\nlines, and 71 minutes: 88°71'49\"";
  const std::string text =
      recoveryText({QStringLiteral("/a \"b\"\nc/µ.alidade"), QByteArray("\x01\xff", 2), now, session});
  const Result<RecoveryRecord> read = readRecovery(text);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->path, QStringLiteral("/a \"b\"\nc/µ.alidade"));
  EXPECT_EQ(read->sha256, QByteArray("\x01\xff", 2));
  EXPECT_EQ(read->keptAt, now);
  EXPECT_EQ(read->session, session);
}

TEST(RecoveryRecord, RefusesWhatIsNone) {
  const std::string good = recoveryText({{}, {}, QDateTime::currentDateTime(), paperSession()});
  EXPECT_TRUE(readRecovery(good));
  for (const std::string& bad :
       {std::string(), std::string("{}"), std::string("{}\n{}"), good.substr(good.find('\n')),
        good.substr(0, good.size() / 2), good.substr(0, good.find('\n'))})
    EXPECT_FALSE(readRecovery(bad)) << bad.substr(0, 40);
}

}  // namespace
}  // namespace alidade::ui
