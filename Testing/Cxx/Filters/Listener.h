// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef Listener_h
#define Listener_h

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

#include <string>
#include <vector>

/** Collects the texts of an algorithm's events instead of printing them. */
class Listener
{
public:
  Listener(vtkAlgorithm* algorithm, unsigned long event)
  {
    this->Command->SetClientData(&this->Texts);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* texts, void* text) {
        static_cast<std::vector<std::string>*>(texts)->push_back(static_cast<const char*>(text));
      });
    algorithm->AddObserver(event, this->Command);
    if (event == vtkCommand::ErrorEvent)
    {
      algorithm->GetExecutive()->AddObserver(event, this->Silence); // its generic line adds nothing
    }
    this->Silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  }

  bool Heard(const std::string& words) const
  {
    for (const std::string& text : this->Texts)
    {
      if (text.find(words) != std::string::npos)
      {
        return true;
      }
    }
    return false;
  }

  std::vector<std::string> Texts;

private:
  vtkNew<vtkCallbackCommand> Command;
  vtkNew<vtkCallbackCommand> Silence;
};

#endif
