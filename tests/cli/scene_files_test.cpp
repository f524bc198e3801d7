// SPDX-License-Identifier: Apache-2.0
//
// Files that are given as scenes and are none: one line that says what they are, at once.
#include <sys/stat.h>

#include "scratch.h"

namespace snell::test {
namespace {

class SceneFiles : public InScratchFolder {
 protected:
  // What "snell check" says of the file.
  std::string Complaint(const std::string& name) {
    const Result result = Run({"check", name});
    EXPECT_EQ(result.status, 1) << name;
    EXPECT_EQ(result.out, "");
    return result.err;
  }
  std::string Complaint(const std::string& name, const std::string& text) {
    Write(name, text);
    return Complaint(name);
  }
};

TEST_F(SceneFiles, FoldersAndPipesAreNone) {
  std::filesystem::create_directory(folder_ / "folder");
  std::filesystem::create_directory(folder_ / "folder.toml");
  for (const std::string name : {"folder", "folder.toml"})
    EXPECT_EQ(Run({"render", name}).err,
              "snell: error: " + name + ": this is a folder, not a file\n");

  // Nobody will ever write to this one
  ASSERT_EQ(::mkfifo(Path("pipe.toml").c_str(), 0600), 0);
  EXPECT_EQ(Complaint("pipe.toml"), "snell: error: pipe.toml: not a regular file\n");
}

TEST_F(SceneFiles, WhatDoesNotExistIsSaidToBeMissing) {
  for (const std::string name : {"none", "none.toml", "none.obj"})
    EXPECT_EQ(Complaint(name),
              "snell: error: " + name + ": cannot read the file: No such file or directory\n");
  EXPECT_EQ(Complaint("a.toml", "include = \"none.toml\"\n[[object]]\nfile = \"none.obj\"\n"),
            "snell: error: a.toml:1:11: there is no file 'none.toml'\n"
            "snell: error: a.toml:3:8: there is no file 'none.obj'\n");
}

TEST_F(SceneFiles, WhatIsNoTextIsSaidToBeNone) {
  const std::string noText = ": not a text file in ASCII or UTF-8: it holds zero bytes";
  const std::string utf16("\xff\xfe[\0", 4);
  for (const std::string name : {"a.toml", "a.obj"})
    EXPECT_EQ(Complaint(name, std::string("a\0b", 3)), "snell: error: " + name + noText + "\n");
  EXPECT_EQ(Complaint("a.toml", utf16),
            "snell: error: a.toml" + noText + "; it seems to be UTF-16; save it as UTF-8\n");
}

TEST_F(SceneFiles, TheNameOfThePictureIsToldOnlyOfAGoodScene) {
  const Result bad = Run({"render", "none.toml"});
  EXPECT_EQ(bad.err, "snell: error: none.toml: cannot read the file: No such file or directory\n");
  Write("a.nff", SpheresScene());
  const Result good = Run({"render", "a.nff"});
  EXPECT_NE(good.err.find("snell: the picture will be 'a.png'; -o chooses another name\n"),
            std::string::npos)
      << good.err;
}

}  // namespace
}  // namespace snell::test
