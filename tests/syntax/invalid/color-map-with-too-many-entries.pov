#version 3.7;
sphere { 0, 1
  pigment {
    gradient y
    color_map { #for (I, 0, 256) [I/256 rgb I/256] #end }
  }
}
