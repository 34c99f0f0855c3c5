#include <gmock/gmock.h>

#include <filesystem>

#include "tests/console/console.h"
#include "tests/support/file_content.h"

namespace alidade::test {
namespace {

using ::testing::HasSubstr;

/// Temporary keys and certificates, and openssl's verdict on a signature.
class SignatureTest : public ::testing::Test {
 protected:
  ProgramRun openssl(const std::vector<std::string>& arguments) const {
    return runProgram({.program = "openssl", .arguments = arguments, .directory = m_folder.path()});
  }

  /// Makes NAME.key and NAME.pem, with a key of that kind.
  void make(const std::string& name, const std::string& kind,
            const std::vector<std::string>& further = {}) const {
    std::vector<std::string> arguments{"req",         "-x509", "-newkey",     kind,    "-keyout",
                                       name + ".key", "-out",  name + ".pem", "-subj", "/CN=" + name};
    if (kind == "ec") arguments.insert(arguments.end(), {"-pkeyopt", "ec_paramgen_curve:P-256"});
    if (further.empty()) arguments.push_back("-nodes");
    arguments.insert(arguments.end(), further.begin(), further.end());
    const ProgramRun run = openssl(arguments);
    ASSERT_EQ(run.exitCode, 0) << run.err;
  }

  ProgramRun sign(const std::string& key, const std::string& certificate,
                  std::vector<std::string> further = {},
                  const std::map<std::string, std::string>& environment = {}) const {
    further.insert(further.begin(), {"certificate", paperSession, "--draft", "--measured-on", "2026-01-02",
                                     "--out", "c.xml", "--sign-key", key, "--sign-certificate", certificate});
    return runProgram({.program = ALIDADE_CLI,
                       .arguments = further,
                       .directory = m_folder.path(),
                       .environment = environment});
  }

  bool verifies(const std::string& content, const std::string& authority) const {
    return openssl({"cms", "-verify", "-binary", "-inform", "DER", "-in", "c.xml.p7s", "-content", content,
                    "-CAfile", authority, "-purpose", "any", "-out", "verified"})
               .exitCode == 0;
  }

  bool isThere(const char* name) const { return std::filesystem::exists(m_folder.path() / name); }

  const TemporaryFolder m_folder;
};

TEST_F(SignatureTest, IsVerifiedByOpenSslAndOfThoseBytesAlone) {
  for (const char* kind : {"rsa:2048", "ec"}) {
    SCOPED_TRACE(kind);
    make("lab", kind);
    const ProgramRun run = sign("lab.key", "lab.pem");
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(verifies("c.xml", "lab.pem"));
    EXPECT_EQ(contentOf(m_folder.path() / "verified"), contentOf(m_folder.path() / "c.xml"));
    std::string changed = contentOf(m_folder.path() / "c.xml");
    changed[changed.size() / 2] ^= 1;
    EXPECT_FALSE(verifies(m_folder.file("changed.xml", changed), "lab.pem"));
    make("other", kind);
    EXPECT_FALSE(verifies("c.xml", "other.pem")) << "of another authority";
  }
}

TEST_F(SignatureTest, TakesThePassphraseFromTheEnvironmentOrAFile) {
  make("lab", "rsa:2048", {"-passout", "pass:open sesame"});
  EXPECT_EQ(sign("lab.key", "lab.pem", {}, {{"ALIDADE_SIGN_PASSPHRASE", "open sesame"}}).exitCode, 0);
  EXPECT_TRUE(verifies("c.xml", "lab.pem"));
  const std::string file = m_folder.file("passphrase", "open sesame\nnot this\n");
  EXPECT_EQ(sign("lab.key", "lab.pem", {"--sign-passphrase-file", file}).exitCode, 0);
  EXPECT_TRUE(verifies("c.xml", "lab.pem"));
}

TEST_F(SignatureTest, RefusesKeysAndCertificatesThatAreNoGoodAndWritesNothing) {
  make("lab", "rsa:2048");
  make("other", "rsa:2048");
  make("locked", "rsa:2048", {"-passout", "pass:secret"});
  const auto refused = [&](const ProgramRun& run, const char* because) {
    expectRefusal(run);
    EXPECT_THAT(run.err, HasSubstr(because));
    EXPECT_FALSE(isThere("c.xml"));
    EXPECT_FALSE(isThere("c.xml.p7s"));
  };
  refused(sign("lab.key", "other.pem"), "belong together");
  refused(sign("none.key", "lab.pem"), "none.key");
  refused(sign("lab.pem", "lab.pem"), "no private key");
  refused(sign("lab.key", "lab.key"), "no certificate");
  refused(sign("locked.key", "locked.pem"), "ALIDADE_SIGN_PASSPHRASE");
  refused(sign("locked.key", "locked.pem", {}, {{"ALIDADE_SIGN_PASSPHRASE", "wrong"}}),
          "cannot be opened with this passphrase");
  refused(sign("locked.key", "locked.pem", {"--sign-passphrase-file", "none"}), "none");
}

TEST_F(SignatureTest, RefusesACertificateThatHasExpired) {
  ASSERT_EQ(openssl({"genpkey", "-algorithm", "RSA", "-out", "old.key"}).exitCode, 0);
  ASSERT_EQ(openssl({"req", "-new", "-key", "old.key", "-subj", "/CN=old", "-out", "old.csr"}).exitCode, 0);
  const ProgramRun made =
      openssl({"x509", "-req", "-in", "old.csr", "-signkey", "old.key", "-days", "-1", "-out", "old.pem"});
  if (made.exitCode != 0) GTEST_SKIP() << made.err;
  const ProgramRun run = sign("old.key", "old.pem");
  expectRefusal(run);
  EXPECT_THAT(run.err, HasSubstr("has expired"));
  EXPECT_FALSE(isThere("c.xml"));
}

// All or nothing: if the signature cannot be written, the certificate is not written either.
TEST_F(SignatureTest, LeavesNoFileUnsigned) {
  make("lab", "rsa:2048");
  std::filesystem::create_directory(m_folder.path() / "c.xml.p7s");
  expectRefusal(sign("lab.key", "lab.pem"));
  EXPECT_FALSE(isThere("c.xml"));
}

TEST_F(SignatureTest, ReplacesNothingThatItIsSignedBy) {
  make("lab", "ec");
  const std::string passphrase = m_folder.file("passphrase.p7s", "none\n");
  for (const std::string out : {"lab.key", "lab.pem", "passphrase.p7s", "passphrase"}) {
    const std::string key = contentOf(m_folder.path() / "lab.key"),
                      certificate = contentOf(m_folder.path() / "lab.pem");
    const ProgramRun run =
        runProgram({.program = ALIDADE_CLI,
                    .arguments = {"certificate", paperSession, "--draft", "--measured-on", "2026-01-02",
                                  "--out", out, "--sign-key", "lab.key", "--sign-certificate", "lab.pem",
                                  "--sign-passphrase-file", "passphrase.p7s"},
                    .directory = m_folder.path()});
    expectRefusal(run);
    EXPECT_EQ(contentOf(m_folder.path() / "lab.key"), key);
    EXPECT_EQ(contentOf(m_folder.path() / "lab.pem"), certificate);
    EXPECT_EQ(contentOf(passphrase), "none\n");
    EXPECT_FALSE(isThere("passphrase"));
  }
}

// The program refuses a key that others can read, as ssh does.
TEST_F(SignatureTest, RefusesAKeyOfOursThatIsOpenToOthers) {
  make("lab", "ec");
  for (const int mode : {0666, 0640, 0604, 0620}) {
    std::filesystem::permissions(m_folder.path() / "lab.key", std::filesystem::perms(mode));
    const ProgramRun run = sign("lab.key", "lab.pem");
    expectRefusal(run);
    EXPECT_THAT(run.err, HasSubstr("lab.key: is accessible to other users"));
    EXPECT_FALSE(isThere("c.xml"));
  }
  std::filesystem::permissions(m_folder.path() / "lab.key", std::filesystem::perms(0400));
  EXPECT_EQ(sign("lab.key", "lab.pem").exitCode, 0);
}

TEST_F(SignatureTest, NeedsBothKeyAndCertificate) {
  expectRefusal(alidadeCli({"certificate", paperSession, "--out", "x.xml", "--sign-key", "k"}));
  expectRefusal(alidadeCli({"certificate", paperSession, "--out", "x.xml", "--sign-certificate", "k"}));
}

}  // namespace
}  // namespace alidade::test
