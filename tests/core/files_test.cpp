// files_test.cpp -- atomic writes, whole reads, and files that may be read beside a mesh.
#include "core/files.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "core/beside.h"
#include "reading.h"

namespace pelage {
namespace {

namespace fs = std::filesystem;
using test::bytesOf;
using test::refusal;
using test::TempFolder;

std::string textOf(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(Files, WrittenBytesAreReadBack) {
    const TempFolder folder;
    const std::string path = folder.path("a.bin");
    std::vector<std::byte> bytes(100000);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i * 7 & 0xff);
    writeFileAtomically(path, bytes);
    EXPECT_EQ(readFile(path, bytes.size()), bytes);
    writeFileAtomically(path, {});
    EXPECT_TRUE(readFile(path, 0).empty());
    EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(Files, WritingKeepsPermissions) {
    const TempFolder folder;
    const std::string path = folder.write("a.bin", "old");
    ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
    writeFileAtomically(path, bytesOf("new"));
    struct stat about {};
    ASSERT_EQ(::stat(path.c_str(), &about), 0);
    EXPECT_EQ(about.st_mode & 07777u, 0640u);
    EXPECT_EQ(textOf(readFile(path, 10)), "new");
}

TEST(Files, NewFilesFollowTheMask) {
    const TempFolder folder;
    const mode_t old = ::umask(027);
    writeFileAtomically(folder.path("a.bin"), bytesOf("x"));
    ::umask(old);
    struct stat about {};
    ASSERT_EQ(::stat(folder.path("a.bin").c_str(), &about), 0);
    EXPECT_EQ(about.st_mode & 07777u, 0640u);
}

TEST(Files, AProcessKilledWhileItWritesLeavesNothing) {
    const TempFolder folder;
    const std::string path = folder.write("a.bin", "old");
    const int probe = ::open(folder.path("").c_str(), O_TMPFILE | O_WRONLY, 0600);
    if (probe < 0) GTEST_SKIP() << "this file system has no files without names";
    ::close(probe);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        // A file that may not become so large: the system kills who writes on.
        const rlimit limit{1 << 16, 1 << 16};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        const rlimit noCore{0, 0};
        ::setrlimit(RLIMIT_CORE, &noCore);
        ::signal(SIGXFSZ, SIG_DFL);
        writeFileAtomically(path, std::vector<std::byte>(1 << 20));
        ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(textOf(readFile(path, 10)), "old");
    EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(Files, NamesMayBeAsLongAsTheSystemAllows) {
    const TempFolder folder;
    const std::string path = folder.path(std::string(251, 'n') + ".glb");
    writeFileAtomically(path, bytesOf("new"));
    EXPECT_EQ(textOf(readFile(path, 10)), "new");
}

TEST(Files, WritingFollowsALinkToWhatItNames) {
    const TempFolder folder;
    folder.write("sub/real.bin", "old");
    fs::create_symlink("sub/real.bin", folder.path("link.bin"));
    writeFileAtomically(folder.path("link.bin"), bytesOf("new"));
    EXPECT_TRUE(fs::is_symlink(folder.path("link.bin")));
    EXPECT_EQ(textOf(readFile(folder.path("sub/real.bin"), 10)), "new");

    fs::create_symlink("circle.bin", folder.path("circle.bin"));
    EXPECT_TRUE(contains(refusal([&] { writeFileAtomically(folder.path("circle.bin"), {}); }),
                         "circle.bin: cannot follow the link"));
}

TEST(Files, AFailedWriteLeavesNothingBehind) {
    const TempFolder folder;
    fs::create_directory(folder.path("taken"));
    const std::string message =
        refusal([&] { writeFileAtomically(folder.path("taken"), bytesOf("x")); });
    EXPECT_EQ(message, folder.path("taken") + ": cannot write: Is a directory");
    EXPECT_EQ(folder.fileCount(), 1u);
    EXPECT_TRUE(contains(refusal([&] { writeFileAtomically(folder.path("no/such/a.bin"), {}); }),
                         "a.bin: cannot write beside it: No such file or directory"));
}

TEST(Files, AFolderIsMadeWithAllAboveIt) {
    const TempFolder folder;
    makeFolder(folder.path("a/b/c"));
    makeFolder(folder.path("a/b/c"));
    EXPECT_TRUE(std::filesystem::is_directory(folder.path("a/b/c")));
    const std::string file = folder.write("file", "x");
    EXPECT_EQ(refusal([&] { makeFolder(file); }), file + ": Not a directory");
    EXPECT_EQ(refusal([&] { makeFolder(file + "/d"); }), file + "/d: Not a directory");
}

TEST(Files, ExtensionsAreComparedWithoutCase) {
    for (const char* name : {"a.glb", "some/where.d/a.b.GlB", "../.a.GLB"})
        EXPECT_TRUE(hasExtension(name, ".glb")) << name;
    for (const char* name : {"", "glb", ".glb", "a.glb.obj", "a.glbx", "a.gl", "a.glb/b", "a.glb/"})
        EXPECT_FALSE(hasExtension(name, ".glb")) << name;
}

TEST(Files, ANameWithoutTheExtensionIsRefused) {
    EXPECT_NO_THROW(expectExtension("horse.GLB", ".glb"));
    EXPECT_EQ(refusal([] { expectExtension("horse.obj", ".glb"); }),
              "\"horse.obj\" does not end in .glb");
}

TEST(Files, ReadingRefusesWhatIsMissingTooLongOrNoFile) {
    const TempFolder folder;
    EXPECT_EQ(refusal([&] { readFile(folder.path("none"), 10); }),
              folder.path("none") + ": No such file or directory");
    EXPECT_EQ(refusal([&] { readFile(folder.path("."), 10); }),
              folder.path(".") + ": is not a regular file");
    const std::string path = folder.write("long", "12345678901");
    EXPECT_EQ(refusal([&] { readFile(path, 10); }),
              path + ": is 11 bytes long; at most 10 are read");
    // A pipe without a writer must not hang.
    ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
    EXPECT_EQ(refusal([&] { readFile(folder.path("pipe"), 10); }),
              folder.path("pipe") + ": is not a regular file");
}

TEST(Beside, FilesOfTheFolderAreRead) {
    const TempFolder folder;
    const std::string owner = folder.write("mesh.gltf", "{}");
    folder.write("a b.bin", "blank");
    folder.write("parts/c.bin", "deep");
    folder.write("d%zz.bin", "percent");
    fs::create_symlink("a b.bin", folder.path("inside.bin"));
    EXPECT_EQ(textOf(readBeside(owner, "a b.bin", 100)), "blank");
    EXPECT_EQ(textOf(readBeside(owner, "a%20b.bin", 100)), "blank");
    EXPECT_EQ(textOf(readBeside(owner, "./parts/c.bin", 100)), "deep");
    EXPECT_EQ(textOf(readBeside(owner, "d%zz.bin", 100)), "percent");
    EXPECT_EQ(textOf(readBeside(owner, "inside.bin", 100)), "blank");
}

TEST(Beside, ReferencesOutOfTheFolderAreRefused) {
    const TempFolder folder;
    folder.write("secret.bin", "secret");
    folder.write("inner2/secret.bin", "secret");
    const std::string owner = folder.write("inner/mesh.gltf", "{}");
    fs::create_symlink("../secret.bin", folder.path("inner/link.bin"));
    fs::create_symlink("..", folder.path("inner/up"));
    const std::string absolute = folder.path("secret.bin");
    for (const std::string& uri : {std::string("../secret.bin"),
                                   std::string("%2e%2e/secret.bin"),
                                   std::string("%2E%2E%2Fsecret.bin"),
                                   std::string("sub/../../secret.bin"),
                                   std::string("..\\secret.bin"),
                                   absolute,
                                   "%2f" + absolute.substr(1),
                                   "file://" + absolute,
                                   "file:" + absolute,
                                   std::string("http://127.0.0.1/secret.bin"),
                                   std::string("C:secret.bin"),
                                   std::string("~/secret.bin"),
                                   std::string("link.bin"),
                                   std::string("up/secret.bin"),
                                   std::string("up/inner2/secret.bin"),
                                   std::string("../inner2/secret.bin"),
                                   std::string("."),
                                   std::string(),
                                   std::string("|cat secret.bin"),
                                   std::string("$(cat secret.bin)"),
                                   std::string("`cat secret.bin`"),
                                   std::string("a.bin?x"),
                                   std::string("a\nb.bin"),
                                   std::string("a%00b.bin")}) {
        const std::string message = refusal([&] { pathBeside(owner, uri); });
        EXPECT_TRUE(contains(message, owner + ": reference \"")) << uri << " -> " << message;
        EXPECT_FALSE(contains(message, "\n")) << uri;
    }
    EXPECT_TRUE(contains(refusal([] { pathBeside("", "a.bin"); }), "no folder to look in"));
}

TEST(Beside, AMissingFileIsNamed) {
    const TempFolder folder;
    const std::string owner = folder.write("mesh.gltf", "{}");
    EXPECT_TRUE(contains(refusal([&] { readBeside(owner, "none.bin", 100); }),
                         owner + ": reference \"none.bin\": "));
}

}  // namespace
}  // namespace pelage
