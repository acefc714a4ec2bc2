// level_task.cpp -- a thread of its own for a level.
#include "app/render/level_task.h"

#include <chrono>
#include <utility>

namespace pelage {

LevelTask::LevelTask(std::shared_ptr<const Skin> skin, int level)
    : level_(level), made_(std::async(std::launch::async, [this, level, skin = std::move(skin)] {
          return makeSkinLevel(*skin, level, &progress_);
      })) {}

LevelTask::~LevelTask() {
    progress_.cancel = true;
    if (made_.valid()) made_.wait();
}

bool LevelTask::ready() const {
    return made_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace pelage
