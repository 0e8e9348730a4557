#declare Pile = sphere { 0, 1 }
#declare I = 0;
#while (I < 1000000)
  #declare Pile = union {
    sphere { I*y, 1 }
    object { Pile }
  }
  #declare I = I + 1;
#end
object { Pile }
