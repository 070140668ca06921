// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggStatus.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace dgg
{
namespace
{
/// Returns a sentence for use after a colon. Names and abbreviations, whose first words have more
/// capitals, keep theirs.
std::string Uncapitalize(std::string sentence)
{
  const auto isCapital = [](unsigned char c) { return std::isupper(c) != 0; };
  const std::string first = sentence.substr(0, sentence.find(' '));
  if (std::count_if(first.begin(), first.end(), isCapital) == 1)
  {
    sentence[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
  }
  return sentence;
}
}

//------------------------------------------------------------------------------
std::string Status::GetMessage() const
{
  const std::string problem = this->Problem.empty() ? "" : this->Problem + ".";
  return this->Action.empty() ? problem : problem + " " + this->Action + ".";
}

//------------------------------------------------------------------------------
Status Status::At(std::string parameter, Offset index) const
{
  Status status = *this;
  status.Parameter = std::move(parameter);
  status.Index = index;
  return status;
}

//------------------------------------------------------------------------------
Status Status::Of(const std::string& subject) const
{
  Status status = *this;
  if (!this->IsOk() && !this->IsAborted())
  {
    status.Problem = subject + ": " + Uncapitalize(this->Problem);
  }
  return status;
}

//------------------------------------------------------------------------------
void AppendNumber(std::string& text, double number)
{
  std::ostringstream stream;
  stream << number;
  text += stream.str();
}

//------------------------------------------------------------------------------
std::string Render(
  const std::string& message, const std::function<std::string(const std::string&)>& nameOf)
{
  std::string text;
  std::size_t done = 0;
  for (std::size_t begin = message.find('{'); begin != std::string::npos;
       begin = message.find('{', done))
  {
    const std::size_t end = message.find('}', begin);
    if (end == std::string::npos)
    {
      break;
    }
    const std::string name = message.substr(begin + 1, end - begin - 1);
    const bool isProperty =
      std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
    text += message.substr(done, begin - done);
    text += !isProperty ? "{" + name + "}" : nameOf ? nameOf(name) : name;
    done = end + 1;
  }
  return text + message.substr(done);
}
}
