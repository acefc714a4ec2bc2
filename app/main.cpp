// main.cpp -- the program: the command line, and the editor where there is no verb.
#include "app/cli/cli.h"
#if __has_include("app/window.h")
#include "app/window.h"
#else
namespace pelage {
void runEditor(const std::string&) { throw std::runtime_error("the editor is not built yet"); }
}  // namespace pelage
#endif

int main(int argc, char** argv) { return pelage::runCommandLine(argc, argv, pelage::runEditor); }
