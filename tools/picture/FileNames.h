// SPDX-License-Identifier: Apache-2.0
// Names of files as a FAT stick gives them: the same file may be called SENSORS.CSV or sensors.csv,
// so that no ending and no fixed name tells anything by its case.
#pragma once

#include <filesystem>
#include <string>

namespace kelpie::picture {

inline std::string lowerCase(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// ".png" of "shots/GOAL.PNG"; empty when there is none.
inline std::string endingOf(const std::filesystem::path& path) {
  return lowerCase(path.extension().string());
}

// What lies in the folder under that name in whatever case; the name as it is when nothing does.
inline std::string fileIn(const std::string& folder, const std::string& name) {
  std::error_code error;
  std::string path = folder + "/" + name;
  if (std::filesystem::exists(path, error)) return path;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (lowerCase(entry.path().filename().string()) == name) return entry.path().string();
  return path;
}

}  // namespace kelpie::picture
