// main.cpp -- the program: what it does is in cli/ (verbs) and window.h (the editor).
#include "app/cli/cli.h"

int main(int argc, char** argv) { return pelage::runCommandLine(argc, argv); }
