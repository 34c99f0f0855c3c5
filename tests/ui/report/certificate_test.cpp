#include "ui/report/certificate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>

#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/main_window.h"

// The program writes certificates without a display; external tools examine them.

namespace alidade::ui {
namespace {

using testing::HasSubstr;

class WrittenCertificateTest : public testing::Test {
 protected:
  WrittenCertificateTest() {
    Session session = paperSession();
    session.measuredOn = "2026-03-01";
    session.report.number = "K-17";
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(writeSession(session)));
  }

  QString in(const char* name) const { return folder.filePath(QString::fromLatin1(name)); }
  static QByteArray bytesOf(const QString& name) {
    QFile file(name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return file.readAll();
  }

  /// Returns the exit code; stderr goes to `errors`.
  int run(const QString& name, const QStringList& arguments) {
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* gone : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
      environment.remove(QString::fromLatin1(gone));
    environment.insert(QStringLiteral("SOURCE_DATE_EPOCH"),
                       QStringLiteral("1772452800"));  // 2026-03-02, noon
    program.setProcessEnvironment(environment);
    program.start(name, arguments);
    EXPECT_TRUE(program.waitForFinished(120000));
    errors = QString::fromUtf8(program.readAllStandardError());
    out = program.readAllStandardOutput();
    return program.exitCode();
  }
  int alidade(const QStringList& arguments) { return run(QStringLiteral(ALIDADE_PROGRAM), arguments); }

  void expectConforms(const QString& certificate) {
    EXPECT_EQ(run(QStringLiteral("xmllint"),
                  {QStringLiteral("--nonet"), QStringLiteral("--noout"), QStringLiteral("--huge"),
                   QStringLiteral("--schema"), QStringLiteral(ALIDADE_REFERENCE_DIR "/dcc/dcc_3_2_0.xsd"),
                   certificate}),
              0)
        << errors.toStdString();
  }
  /// The text found by an XPath.
  QByteArray found(const QString& certificate, const QString& where) {
    EXPECT_EQ(run(QStringLiteral("xmllint"),
                  {QStringLiteral("--nonet"), QStringLiteral("--huge"), QStringLiteral("--xpath"),
                   QStringLiteral("string(%1)").arg(where), certificate}),
              0);
    return out.trimmed();
  }

  QTemporaryDir folder;
  QString path = in("session.alidade"), errors;
  QByteArray out;
};

const QString pdfWithin = QStringLiteral("/*/*[local-name()='document']/*[local-name()='dataBase64']");

TEST_F(WrittenCertificateTest, HoldsTheReportOfThatDayByteForByte) {
  const QString certificate = in("c.xml"), report = in("r.pdf");
  ASSERT_EQ(alidade({QStringLiteral("--certificate"), certificate, QStringLiteral("--draft"),
                     QStringLiteral("--country"), QStringLiteral("DE"), path}),
            0)
      << errors.toStdString();
  EXPECT_EQ(errors.count(u'\n'), 1);
  EXPECT_THAT(errors.toStdString(), HasSubstr("“not stated”"));
  ASSERT_EQ(alidade({QStringLiteral("--report"), report, path}), 0);
  expectConforms(certificate);
  EXPECT_EQ(QByteArray::fromBase64(found(certificate, pdfWithin)), bytesOf(report));
  EXPECT_EQ(QByteArray::fromBase64(found(
                certificate, QStringLiteral("(//*[local-name()='file']/*[local-name()='dataBase64'])[1]"))),
            bytesOf(path));
  EXPECT_EQ(found(certificate, QStringLiteral("//*[local-name()='issueDate']")), "2026-03-02");
  EXPECT_EQ(found(certificate, QStringLiteral("//*[local-name()='countryCodeISO3166_1']")), "DE");
  const QByteArray first = bytesOf(certificate);
  ASSERT_EQ(alidade({QStringLiteral("--certificate"), certificate, QStringLiteral("--draft"),
                     QStringLiteral("--country"), QStringLiteral("DE"), path}),
            0);
  EXPECT_EQ(bytesOf(certificate), first) << "the same each time";
}

TEST_F(WrittenCertificateTest, SpeaksTheLanguageOfTheReportBesideEnglish) {
  const QString certificate = in("c.xml");
  ASSERT_EQ(alidade({QStringLiteral("--language"), QStringLiteral("zh_CN"), QStringLiteral("--certificate"),
                     certificate, QStringLiteral("--draft"), path}),
            0)
      << errors.toStdString();
  expectConforms(certificate);
  const auto name = [&](const char* language) {
    return found(certificate, QStringLiteral("//*[@id='conformity']/*[local-name()='name']/*[@lang='%1']")
                                  .arg(QString::fromLatin1(language)));
  };
  EXPECT_EQ(name("en"), "Statement of conformity");
  EXPECT_EQ(name("zh"), "符合性声明");
  EXPECT_EQ(found(certificate, QStringLiteral("//*[local-name()='mandatoryLangCodeISO639_1']")), "en");
}

TEST_F(WrittenCertificateTest, IsSignedAsTheReportIs) {
  const QString key = in("k.pem"), holder = in("c.pem");
  ASSERT_EQ(run(QStringLiteral("openssl"),
                {QStringLiteral("req"), QStringLiteral("-x509"), QStringLiteral("-newkey"),
                 QStringLiteral("rsa:2048"), QStringLiteral("-nodes"), QStringLiteral("-keyout"), key,
                 QStringLiteral("-out"), holder, QStringLiteral("-subj"), QStringLiteral("/CN=Laboratory")}),
            0);
  const auto verifies = [&](const QString& file) {
    return run(QStringLiteral("openssl"),
               {QStringLiteral("cms"), QStringLiteral("-verify"), QStringLiteral("-binary"),
                QStringLiteral("-inform"), QStringLiteral("DER"), QStringLiteral("-in"),
                file + QStringLiteral(".p7s"), QStringLiteral("-content"), file, QStringLiteral("-CAfile"),
                holder, QStringLiteral("-purpose"), QStringLiteral("any"), QStringLiteral("-out"),
                QStringLiteral("/dev/null")}) == 0;
  };
  const QStringList signedBy{QStringLiteral("--sign-key"), key, QStringLiteral("--sign-certificate"), holder,
                             path};
  for (const char* kind : {"--report", "--certificate"}) {
    const QString file = in(kind);
    QStringList call{QString::fromLatin1(kind), file};
    if (call[0] == QStringLiteral("--certificate")) call.append(QStringLiteral("--draft"));
    ASSERT_EQ(alidade(call + signedBy), 0) << errors.toStdString();
    EXPECT_TRUE(verifies(file)) << errors.toStdString();
    QFile changed(file);
    ASSERT_TRUE(changed.open(QIODevice::ReadWrite) && changed.seek(1000));
    const char byte = changed.peek(1)[0];
    changed.write(QByteArray(1, static_cast<char>(byte ^ 1)));
    changed.close();
    EXPECT_FALSE(verifies(file));
  }
  const QByteArray keyBefore = bytesOf(key), holderBefore = bytesOf(holder);
  for (const char* kind : {"--report", "--certificate"})
    for (const QString& input : {key, holder}) {
      EXPECT_EQ(alidade(QStringList{QString::fromLatin1(kind), input} + signedBy), 2);
      EXPECT_EQ(bytesOf(key), keyBefore);
      EXPECT_EQ(bytesOf(holder), holderBefore);
    }
  EXPECT_EQ(alidade({QStringLiteral("--report"), in("unsigned.pdf"), QStringLiteral("--sign-key"), QString(),
                     QStringLiteral("--sign-certificate"), QString(), path}),
            2);
  EXPECT_FALSE(QFile::exists(in("unsigned.pdf")));
  const QString never = in("never.pdf");
  EXPECT_EQ(alidade({QStringLiteral("--report"), never, QStringLiteral("--sign-key"), holder,
                     QStringLiteral("--sign-certificate"), holder, path}),
            2);
  EXPECT_EQ(errors.count(u'\n'), 1);
  EXPECT_FALSE(QFile::exists(never));
}

TEST_F(WrittenCertificateTest, RefusesCallsThatDoNotGoTogether) {
  const QString certificate = QStringLiteral("--certificate"), to = in("c.xml");
  for (const QStringList& call :
       {QStringList{certificate, to},
        {certificate, to, QStringLiteral("--report"), in("r.pdf"), path},
        {QStringLiteral("--sign-key"), in("k"), path},
        {certificate, to, QStringLiteral("--sign-key"), in("k"), path},
        {QStringLiteral("--report"), in("r.pdf"), QStringLiteral("--country"), QStringLiteral("DE"), path},
        {certificate, to, QStringLiteral("--country"), QStringLiteral("Germany"), path},
        {certificate, to, samplePath(QStringLiteral("paper-table-1.alidade"))}}) {
    EXPECT_EQ(alidade(call), 2) << call.join(u' ').toStdString();
    EXPECT_EQ(errors.count(u'\n'), 1) << errors.toStdString();
    EXPECT_FALSE(QFile::exists(to));
  }
}

TEST_F(WrittenCertificateTest, IsExportedFromTheWindowOnceWhatIsEmptyWasTold) {
  QSettings().remove(QStringLiteral("report"));
  OpenWindow open;
  ASSERT_TRUE(open->files().open(path));
  open.dialogs->exportPath = in("c.xml");
  EXPECT_FALSE(open->files().exportCertificate());
  ASSERT_EQ(open.dialogs->problems.size(), 1);
  EXPECT_THAT(open.dialogs->problems[0].toStdString(), HasSubstr("laboratory"));
  EXPECT_THAT(open.dialogs->problems[0].toStdString(), HasSubstr("country"));
  open.dialogs->problems.clear();
  EXPECT_FALSE(QFile::exists(in("c.xml")));
  open.dialogs->reportQuestions.clear();
  open.dialogs->reportChoice = ReportChoice();
  open.dialogs->reportChoice->certificate = {.country = QStringLiteral("DE"), .isDraft = true};
  ASSERT_TRUE(open->files().exportCertificate());
  EXPECT_TRUE(open.dialogs->problems.isEmpty());
  ASSERT_EQ(open.dialogs->reportQuestions.size(), 1);
  EXPECT_TRUE(open.dialogs->reportQuestions.front().isCertificate);
  EXPECT_EQ(found(in("c.xml"), QStringLiteral("//*[local-name()='countryCodeISO3166_1']")), "DE");
  const QStringList lacks = open.dialogs->reportQuestions.front().emptyFields;
  EXPECT_TRUE(lacks.contains(QStringLiteral("laboratory")));
  EXPECT_FALSE(lacks.contains(QStringLiteral("report number")));
  expectConforms(in("c.xml"));
  EXPECT_TRUE(QByteArray::fromBase64(found(in("c.xml"), pdfWithin)).startsWith("%PDF-1."));
  QFile::remove(in("c.xml"));
  open.dialogs->writeAnyway = false;
  EXPECT_FALSE(open->files().exportCertificate());
  EXPECT_FALSE(QFile::exists(in("c.xml")));
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  EXPECT_FALSE(open->files().exportCertificate());
  ASSERT_EQ(open.dialogs->problems.size(), 1);
  EXPECT_THAT(open.dialogs->problems[0].toStdString(), HasSubstr("day of the measurement"));
}

}  // namespace
}  // namespace alidade::ui
