// level_task.h -- one coarser skin in the making, beside the main thread.
#pragma once

#include <future>
#include <memory>

#include "core/progress.h"
#include "core/skin_levels.h"

namespace pelage {

class LevelTask {
public:
    LevelTask(std::shared_ptr<const Skin> skin, int level);
    ~LevelTask();  // cancels; waits only until that is noticed
    LevelTask(const LevelTask&) = delete;
    LevelTask& operator=(const LevelTask&) = delete;

    int level() const { return level_; }
    bool ready() const;
    SkinLevel take() { return made_.get(); }  // once; waits until it is ready

private:
    int level_;
    Progress progress_;
    std::future<SkinLevel> made_;
};

}  // namespace pelage
