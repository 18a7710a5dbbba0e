#include "docs/page.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace scatter::test {

namespace {

std::vector<std::string> pageLines(const std::string& page) {
  std::vector<std::string> lines;
  std::istringstream stream(page);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

bool isFence(const std::string& line) {
  return line.starts_with("```");
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

// The text up to what explains it.
std::string commandPart(const std::string& text) {
  const std::string line = trimmed(text);
  const std::size_t end = std::min({line.find("  "), line.find(" #"), line.size()});
  return trimmed(line.substr(0, end));
}

bool isCommand(const std::string& text) {
  return text == "./run" || text == "./test" || text.starts_with("./run ") || text.starts_with("./test ") ||
         text.starts_with("scatter ");
}

void addCommand(const std::string& text, std::vector<std::string>& commands) {
  const std::string command = commandPart(text);
  if (isCommand(command) && std::find(commands.begin(), commands.end(), command) == commands.end()) {
    commands.push_back(command);
  }
}

void addInline(const std::string& line, std::vector<std::string>& commands) {
  std::size_t open = line.find('`');
  while (open != std::string::npos) {
    const std::size_t close = line.find('`', open + 1);
    if (close == std::string::npos) {
      return;
    }
    addCommand(line.substr(open + 1, close - open - 1), commands);
    open = line.find('`', close + 1);
  }
}

// The lines from below the heading to the next one.
std::vector<std::string> sectionLines(const std::string& page, const std::string& heading) {
  std::vector<std::string> section;
  bool inside = false;
  for (const std::string& line : pageLines(page)) {
    if (line.starts_with("#")) {
      inside = trimmed(line.substr(line.find_first_not_of('#'))).starts_with(heading);
    } else if (inside) {
      section.push_back(line);
    }
  }
  return section;
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    cells.push_back(trimmed(cell));
  }
  return cells;
}

}  // namespace

std::string readPage(const std::string& name) {
  std::ifstream stream(SCATTER_SOURCE_DIR "/" + name);
  if (!stream) {
    throw std::runtime_error("no page " + name);
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> commandsOf(const std::string& page) {
  std::vector<std::string> commands;
  bool inCode = false;
  for (const std::string& line : pageLines(page)) {
    if (isFence(line)) {
      inCode = !inCode;
    } else if (inCode) {
      addCommand(line, commands);
    } else {
      addInline(line, commands);
    }
  }
  return commands;
}

std::vector<std::vector<std::string>> tableBelow(const std::string& page, const std::string& heading) {
  std::vector<std::vector<std::string>> rows;
  bool inBody = false;
  for (const std::string& line : sectionLines(page, heading)) {
    if (line.starts_with("|---")) {
      inBody = true;
    } else if (!line.starts_with("|")) {
      inBody = false;
    } else if (inBody) {
      rows.push_back(cellsOf(line));
    }
  }
  return rows;
}

std::vector<std::string> codeBelow(const std::string& page, const std::string& heading) {
  std::vector<std::string> code;
  bool inCode = false;
  for (const std::string& line : sectionLines(page, heading)) {
    if (isFence(line)) {
      if (inCode) {
        return code;
      }
      inCode = true;
    } else if (inCode) {
      code.push_back(line);
    }
  }
  return code;
}

std::vector<std::string> wordsOf(const std::string& command) {
  std::vector<std::string> words;
  std::istringstream stream(command);
  for (std::string word; stream >> word;) {
    words.push_back(word);
  }
  return words;
}

}  // namespace scatter::test
