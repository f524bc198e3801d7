// SPDX-License-Identifier: Apache-2.0
//
// The repository as text: what the tests of its structure read. Paths are relative to the repository's root,
// with slashes. Build trees and hidden folders are no part of it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace snell::structure {

struct TextFile {
  std::string path;
  std::vector<std::string> lines;
};

// Folders of the first level that hold our text.
std::vector<std::string> TopFolders();

// The files below `folder` ("" for the whole repository), in order of their paths, whose names end with one
// of `endings`. None if there is no such folder.
std::vector<TextFile> FilesBelow(const std::string& folder,
                                 const std::vector<std::string_view>& endings);

// All C++ and GLSL below `folder`.
std::vector<TextFile> CodeBelow(const std::string& folder);

// Whether there is a file or folder. A '*' in its last part, or the word NAME, stands for anything.
bool Exists(std::string_view path);

TextFile Read(const std::string& path);

// "a/b" for "a/b/c.h", "" for "c.h"; "c.h"; and "c".
std::string FolderOf(const std::string& path);
std::string NameOf(const std::string& path);
std::string StemOf(const std::string& path);

// What `name` means in a file at `path`: "a/d" for "../d" in "a/b/c.h".
std::string Beside(const std::string& path, const std::string& name);

}  // namespace snell::structure
