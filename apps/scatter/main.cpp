#include "program.h"

int main(int argc, char** argv) {
  return scatter::app::runProgram(argc, argv);
}
