#version 3.7;
#include "folder"
